(* Polynomial functions are smooth: for the functions that a refutation gives as witness. *)
Require Import QArith Lia FunctionalExtensionality.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Expressions PatchProof.Normal.
Require Import PatchProof.Smoothness PatchProof.Jets PatchProof.Derivatives
  PatchProof.PolynomialExpressions PatchProof.Values
  PatchProof.Equations.
Local Open Scope R_scope.

Section Functions.
Variable Phi : list (list R -> R).
Variable S : list (nat * nat).
Hypothesis smooth_functions : smooth_all S Phi.
Variable rho : positive -> R.

Lemma slope_in xs x e r t : In x xs -> polynomial_in xs e = true ->
  is_derive (fun t => eval Phi (update r x t) e) t (eval Phi (update r x t) (derivative x e)).
Proof.
  intros i h. destruct (polynomial_differentiable S xs x e i h) as [h1 h2].
  apply (derivative_value Phi S); trivial. rewrite h2. constructor.
Qed.

(* Polynomials are continuous in all their variables together. *)
Lemma eval_continuous (T : UniformSpace) (r : T -> positive -> R) (t0 : T) xs e :
  (forall p, continuous (fun t => r t p) t0) ->
  (forall a, forallb (fun x => negb (occurs x a)) xs = true ->
    forall t, eval Phi (r t) a = eval Phi (r t0) a) ->
  polynomial_in xs e = true -> continuous (fun t => eval Phi (r t) e) t0.
Proof.
  intros hr hc. induction e using ex_induction; cbn [polynomial_in]; intro h;
    try (apply andb_prop in h; destruct h as [h1 h2]).
  - apply continuous_const.
  - apply hr.
  - apply @continuous_plus; auto.
  - apply @continuous_minus; auto.
  - apply @continuous_mult; auto.
  - apply @continuous_opp; auto.
  - specialize (IHe h). simpl. induction n as [|n IH]; [apply continuous_const|].
      now apply @continuous_mult.
  - apply continuous_ext with (fun _ => eval Phi (r t0) (Jet j o l)); [|apply continuous_const].
    intro t. symmetry. now apply hc.
  - apply continuous_ext with (fun _ => eval Phi (r t0) (Inverse e)); [|apply continuous_const].
    intro t. symmetry. now apply hc.
  - apply continuous_ext with (fun _ => eval Phi (r t0) (Root e)); [|apply continuous_const].
    intro t. symmetry. now apply hc.
Qed.

Definition at1 (u : R) := update rho 1 u.
Definition at2 (u v : R) := update (at1 u) 2 v.
Definition at3 (u v w : R) := update (at2 u v) 3 w.
Lemma two_first u v t : update (update (update rho 2 v) 1 u) 1 t = update (update rho 2 v) 1 t.
Proof. apply functional_extensionality. intro p. unfold update. now destruct (Pos.eqb p 1). Qed.
Lemma two_swap u v : at2 u v = update (update rho 2 v) 1 u.
Proof.
  apply functional_extensionality. intro p. unfold at2, at1, update.
  destruct (Pos.eqb_spec p 2), (Pos.eqb_spec p 1); subst; congruence.
Qed.
Lemma three_swap1 u v w : at3 u v w = update (update (update rho 2 v) 3 w) 1 u.
Proof.
  apply functional_extensionality. intro p. unfold at3, at2, at1, update.
  destruct (Pos.eqb_spec p 3), (Pos.eqb_spec p 2), (Pos.eqb_spec p 1); subst; congruence.
Qed.
Lemma three_swap2 u v w : at3 u v w = update (update (update rho 1 u) 3 w) 2 v.
Proof.
  apply functional_extensionality. intro p. unfold at3, at2, at1, update.
  destruct (Pos.eqb_spec p 3), (Pos.eqb_spec p 2), (Pos.eqb_spec p 1); subst; congruence.
Qed.
Lemma free_three a u v w : forallb (fun x => negb (occurs x a)) [1; 2; 3]%positive = true ->
  eval Phi (at3 u v w) a = eval Phi rho a.
Proof.
  simpl. intro h. apply andb_prop in h. destruct h as [h1 h]. apply andb_prop in h.
    destruct h as [h2 h].
  apply andb_prop in h. destruct h as [h3 _]. apply negb_true_iff in h1, h2, h3.
  unfold at3, at2, at1. now rewrite !eval_update.
Qed.
Lemma free_two a u v : forallb (fun x => negb (occurs x a)) [1; 2]%positive = true ->
  eval Phi (at2 u v) a = eval Phi rho a.
Proof.
  simpl. intro h. apply andb_prop in h. destruct h as [h1 h]. apply andb_prop in h.
    destruct h as [h2 _].
  apply negb_true_iff in h1, h2. unfold at2, at1. now rewrite !eval_update.
Qed.

Lemma smooth_one n : forall e, polynomial_in [1%positive] e = true ->
  smooth n (fun u => eval Phi (at1 u) e).
Proof.
  assert (D : forall k e, polynomial_in [1%positive] e = true ->
    exists e', polynomial_in [1%positive] e' = true /\
    Nat.iter k Derive (fun u => eval Phi (at1 u) e) = (fun u => eval Phi (at1 u) e')).
  { induction k as [|k IH]; intros e h; [now exists e|]. destruct (IH e h) as [e' [h' E]].
    exists (derivative 1 e'). split; [apply polynomial_derivative; trivial; now left|]. simpl.
      rewrite E.
    apply functional_extensionality. intro u. apply is_derive_unique.
      apply (slope_in [1%positive]); trivial. now left. }
  intros e h k x _. destruct (D k e h) as [e' [h' ->]]. eexists.
    apply (slope_in [1%positive]); trivial. now left.
Qed.

Lemma smooth_two n : forall e, polynomial_in [1; 2]%positive e = true ->
  smooth2 n (fun u v => eval Phi (at2 u v) e).
Proof.
  assert (C : forall e, polynomial_in [1; 2]%positive e = true ->
    forall u v, continuous2 (fun u v => eval Phi (at2 u v) e) u v).
  { intros e h u v eps he.
    assert (c : continuous (fun p : R * R => eval Phi (at2 (fst p) (snd p)) e) (u, v)).
    { apply (eval_continuous _ (fun p : R * R => at2 (fst p) (snd p)) (u, v) [1; 2]%positive);
      trivial.
      - intro p. unfold at2, at1, update. destruct (Pos.eqb p 2); [apply continuous_snd|].
        destruct (Pos.eqb p 1); [apply continuous_fst|apply continuous_const].
      - intros a ha t. now rewrite !free_two. }
    destruct (proj1 (filterlim_locally _ _) c (mkposreal eps he)) as [d H].
    exists d. split; [apply cond_pos|]. intros x y hx hy. exact (H (x, y) (conj hx hy)). }
  assert (A : forall e, polynomial_in [1; 2]%positive e = true -> forall u v,
    is_derive (fun t => eval Phi (at2 t v) e) u (eval Phi (at2 u v) (derivative 1 e))).
  { intros e h u v. rewrite two_swap. apply is_derive_ext with (fun t => eval Phi (update (update
    rho 2 v) 1 t) e).
    - intro t. now rewrite two_swap.
    - apply (slope_in [1; 2]%positive); trivial. now left. }
  assert (B : forall e, polynomial_in [1; 2]%positive e = true -> forall u v,
    is_derive (fun t => eval Phi (at2 u t) e) v (eval Phi (at2 u v) (derivative 2 e))).
  { intros e h u v. apply (slope_in [1; 2]%positive); trivial. right; now left. }
  induction n as [|n IH]; intros e h; split; try (now apply C); trivial. repeat split.
  - eexists. now apply A.
  - eexists. now apply B.
  - replace (D_u (fun u v => eval Phi (at2 u v) e)) with (fun u v => eval Phi (at2 u v)
      (derivative 1 e)).
    + apply IH, polynomial_derivative; trivial. now left.
    + apply functional_extensionality; intro u. apply functional_extensionality; intro v. symmetry.
      apply is_derive_unique. now apply A.
  - replace (D_v (fun u v => eval Phi (at2 u v) e)) with (fun u v => eval Phi (at2 u v)
      (derivative 2 e)).
    + apply IH, polynomial_derivative; trivial. right; now left.
    + apply functional_extensionality; intro u. apply functional_extensionality; intro v. symmetry.
      apply is_derive_unique. now apply B.
Qed.

Lemma smooth_three n : forall e, polynomial_in [1; 2; 3]%positive e = true ->
  smooth3 n (fun u v w => eval Phi (at3 u v w) e).
Proof.
  assert (C : forall e, polynomial_in [1; 2; 3]%positive e = true ->
    forall u v w, continuous3 (fun u v w => eval Phi (at3 u v w) e) u v w).
  { intros e h u v w eps he.
    assert (c : continuous (fun p : R * R * R => eval Phi (at3 (fst (fst p)) (snd (fst p))
      (snd p)) e) (u, v, w)).
    { apply (eval_continuous _ (fun p : R * R * R => at3 (fst (fst p)) (snd (fst p)) (snd p)) (u,
      v, w)
        [1; 2; 3]%positive); trivial.
      - intro p. unfold at3, at2, at1, update. destruct (Pos.eqb p 3); [apply continuous_snd|].
        destruct (Pos.eqb p 2).
        { apply (continuous_comp fst snd); [apply continuous_fst|apply continuous_snd]. }
        destruct (Pos.eqb p 1); [|apply continuous_const].
        apply (continuous_comp fst fst); apply continuous_fst.
      - intros a ha t. now rewrite !free_three. }
    destruct (proj1 (filterlim_locally _ _) c (mkposreal eps he)) as [d H].
    exists d. split; [apply cond_pos|]. intros x y z hx hy hz.
      exact (H (x, y, z) (conj (conj hx hy) hz)). }
  assert (A : forall e, polynomial_in [1; 2; 3]%positive e = true -> forall u v w,
    is_derive (fun t => eval Phi (at3 t v w) e) u (eval Phi (at3 u v w) (derivative 1 e))).
  { intros e h u v w. rewrite three_swap1.
    apply is_derive_ext with (fun t => eval Phi (update (update (update rho 2 v) 3 w) 1 t) e).
    - intro t. now rewrite three_swap1.
    - apply (slope_in [1; 2; 3]%positive); trivial. now left. }
  assert (B : forall e, polynomial_in [1; 2; 3]%positive e = true -> forall u v w,
    is_derive (fun t => eval Phi (at3 u t w) e) v (eval Phi (at3 u v w) (derivative 2 e))).
  { intros e h u v w. rewrite three_swap2.
    apply is_derive_ext with (fun t => eval Phi (update (update (update rho 1 u) 3 w) 2 t) e).
    - intro t. now rewrite three_swap2.
    - apply (slope_in [1; 2; 3]%positive); trivial. right; now left. }
  assert (B' : forall e, polynomial_in [1; 2; 3]%positive e = true -> forall u v w,
    is_derive (fun t => eval Phi (at3 u v t) e) w (eval Phi (at3 u v w) (derivative 3 e))).
  { intros e h u v w. apply (slope_in [1; 2; 3]%positive); trivial. right; right; now left. }
  induction n as [|n IH]; intros e h; split; try (now apply C); trivial. repeat split.
  - eexists. now apply A.
  - eexists. now apply B.
  - eexists. now apply B'.
  - replace (D_1 (fun u v w => eval Phi (at3 u v w) e)) with (fun u v w => eval Phi (at3 u v w)
      (derivative 1 e)).
    + apply IH, polynomial_derivative; trivial. now left.
    + apply functional_extensionality; intro u. apply functional_extensionality; intro v.
      apply functional_extensionality; intro w. symmetry. apply is_derive_unique. now apply A.
  - replace (D_2 (fun u v w => eval Phi (at3 u v w) e)) with (fun u v w => eval Phi (at3 u v w)
      (derivative 2 e)).
    + apply IH, polynomial_derivative; trivial. right; now left.
    + apply functional_extensionality; intro u. apply functional_extensionality; intro v.
      apply functional_extensionality; intro w. symmetry. apply is_derive_unique. now apply B.
  - replace (D_3 (fun u v w => eval Phi (at3 u v w) e)) with (fun u v w => eval Phi (at3 u v w)
      (derivative 3 e)).
    + apply IH, polynomial_derivative; trivial. right; right; now left.
    + apply functional_extensionality; intro u. apply functional_extensionality; intro v.
      apply functional_extensionality; intro w. symmetry. apply is_derive_unique. now apply B'.
Qed.
End Functions.

(* The body of a function of m variables, these first, is a polynomial in them. *)
Definition leading (m : nat) : list positive := map Pos.of_succ_nat (seq 0 m).
Definition check_polynomial (n m : nat) (body : term) : bool :=
  match value [] 4 (map At (leading m) ++ variables n) body with
  | Some (e, []) => polynomial_in (leading m) (normal e)
  | _ => false
  end.
Lemma variables_fresh x n : (x < 64)%positive -> fresh x (variables n) = true.
Proof.
  intro h. unfold fresh, variables. apply negb_true_iff. generalize (seq 0 n). intro l.
  induction l as [|k l IH]; trivial. cbn [map existsb occurs]. rewrite IH, orb_false_r.
    apply Pos.eqb_neq. lia.
Qed.
Lemma variables_elsewhere Phi sigma x r t : (x < 64)%positive ->
  map (eval Phi r) (variables (length sigma)) = sigma ->
  map (eval Phi (update r x t)) (variables (length sigma)) = sigma.
Proof. intros h e. rewrite fresh_map; trivial. now apply variables_fresh. Qed.

Section Bodies.
Variable Phi : list (list R -> R).
Variable sigma : list R.
Variable n : nat.
Hypothesis length_sigma : length sigma = n.
Lemma variables_one u : map (eval Phi (at1 (assignment sigma) u)) (variables n) = sigma.
Proof. rewrite <- length_sigma. apply variables_elsewhere; [lia|apply variables_value]. Qed.
Lemma variables_two u v : map (eval Phi (at2 (assignment sigma) u v)) (variables n) = sigma.
Proof. rewrite <- length_sigma. apply variables_elsewhere; [lia|]. rewrite length_sigma.
  apply variables_one. Qed.
Lemma variables_three u v w : map (eval Phi (at3 (assignment sigma) u v w)) (variables n) = sigma.
Proof. rewrite <- length_sigma. apply variables_elsewhere; [lia|]. rewrite length_sigma.
  apply variables_two. Qed.
Theorem polynomial_smooth m body : check_polynomial n 1 body = true ->
  smooth m (fun u => denote Phi (u :: sigma) body).
Proof.
  unfold check_polynomial. destruct (value [] 4 _ body) as [[e [|? ?]]|] eqn:E; try discriminate.
    intro h.
  replace (fun u => denote Phi (u :: sigma) body) with (fun u => eval Phi (at1 (assignment sigma)
    u) (normal e)).
  - now apply (smooth_one Phi [] I).
  - apply functional_extensionality; intro u.
    rewrite normal_value, <- (value_correct [] Phi I body _ _ _ _ _ E) by constructor.
      rewrite map_app.
    now rewrite variables_one.
Qed.
Theorem polynomial_smooth2 m body : check_polynomial n 2 body = true ->
  smooth2 m (fun u v => denote Phi (u :: v :: sigma) body).
Proof.
  unfold check_polynomial. destruct (value [] 4 _ body) as [[e [|? ?]]|] eqn:E; try discriminate.
    intro h.
  replace (fun u v => denote Phi (u :: v :: sigma) body) with (fun u v => eval Phi (at2 (assignment
    sigma) u v) (normal e)).
  - now apply (smooth_two Phi [] I).
  - apply functional_extensionality; intro u. apply functional_extensionality; intro v.
    rewrite normal_value, <- (value_correct [] Phi I body _ _ _ _ _ E) by constructor.
      rewrite map_app.
    now rewrite variables_two.
Qed.
Theorem polynomial_smooth3 m body : check_polynomial n 3 body = true ->
  smooth3 m (fun u v w => denote Phi (u :: v :: w :: sigma) body).
Proof.
  unfold check_polynomial. destruct (value [] 4 _ body) as [[e [|? ?]]|] eqn:E; try discriminate.
    intro h.
  replace (fun u v w => denote Phi (u :: v :: w :: sigma) body)
    with (fun u v w => eval Phi (at3 (assignment sigma) u v w) (normal e)).
  - now apply (smooth_three Phi [] I).
  - apply functional_extensionality; intro u. apply functional_extensionality; intro v.
    apply functional_extensionality; intro w.
    rewrite normal_value, <- (value_correct [] Phi I body _ _ _ _ _ E) by constructor.
      rewrite map_app.
    now rewrite variables_three.
Qed.
End Bodies.
Arguments polynomial_smooth Phi sigma n%nat _ m%nat.
Arguments polynomial_smooth2 Phi sigma n%nat _ m%nat.
Arguments polynomial_smooth3 Phi sigma n%nat _ m%nat.
