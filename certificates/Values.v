(* The value of a term as an expression: functions applied, derivatives and integrals worked out. *)
Require Import QArith Qreals Lia Lra micromega.EnvRing.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Jets PatchProof.Derivatives PatchProof.Bases
  PatchProof.Integrals.
Local Open Scope R_scope.

(* The inverse; a product is inverted factor by factor, for the factors may be known to be
  different from 0. *)
Fixpoint inverted (e : ex) : ex :=
  match e with
  | Times a b => Times (inverted a) (inverted b)
  | Power a n => Power (inverted a) n
  | Negate a => Negate (inverted a)
  | Inverse a => a
  | _ => Inverse e
  end.

(* A value, and the expressions that have to be different from 0 for it. *)
Definition result : Type := option (ex * list ex).
Definition lift (f : ex -> ex) (a : result) : result :=
  match a with Some (x, c) => Some (f x, c) | None => None end.
Definition lift2 (f : ex -> ex -> ex) (a b : result) : result :=
  match a, b with Some (x, c), Some (y, d) => Some (f x y, c ++ d) | _, _ => None end.
Definition fresh (x : positive) (l : list ex) : bool := negb (existsb (occurs x) l).

Section Value.
Variable smoothness : list (nat * nat).
Definition slope (x : positive) (a : ex) (v : result) : result :=
  match v with
  | Some (e, c) =>
      let e := normal e in
      if differentiable smoothness x e && forallb (differentiable smoothness x) c then
        Some (normal (substitute x a (derivative x e)),
              map (fun d => normal (substitute x a d))
                  (c ++ denominators x e ++ flat_map (denominators x) c))
      else None
  | None => None
  end.
(* next is a variable that no expression of the environment contains. *)
Fixpoint value (next : positive) (env : list ex) (t : term) {struct t} : result :=
  match t with
  | Int z => Some (Num (inject_Z z), [])
  | Var k => match nth_error env k with Some e => Some (e, []) | None => None end
  | Add a b => lift2 Plus (value next env a) (value next env b)
  | Sub a b => lift2 Minus (value next env a) (value next env b)
  | Mul a b => lift2 Times (value next env a) (value next env b)
  | Opp a => lift Negate (value next env a)
  | Div a b => lift2 (fun x y => Times x (inverted y)) (value next env a) (value next env b)
  | Pow a n => lift (fun x => Power x n) (value next env a)
  | Bernstein n i a => lift (bernstein n i) (value next env a)
  | BSpline l p i s a => lift (spline l p i s) (value next env a)
  | App f l =>
      match (fix values l := match l with
        | [] => Some ([], [])
        | a :: l' => match value next env a, values l' with
            | Some (x, c), Some (xs, d) => Some (normal x :: xs, c ++ d)
            | _, _ => None end end) l with
      | Some (xs, c) => match function_value next env f xs with
          | Some (y, d) => Some (y, c ++ d) | None => None end
      | None => None
      end
  | Integral a b e =>
      match value next env a, value next env b, value (Pos.succ next) (At next :: env) e with
      | Some (x, c), Some (y, d), Some (z, []) =>
          if fresh next env then
            match integral smoothness next x y (normal z) with
            | Some r => Some (r, c ++ d) | None => None end
          else None
      | _, _, _ => None
      end
  | Sqrt a => lift Root (value next env a)
  end
with function_value (next : positive) (env : list ex) (f : fn) (l : list ex) {struct f} : result :=
  match f with
  | Lam _ body => value next (l ++ env) body
  | Deriv k g =>
      match nth_error l k with
      | Some a =>
          if fresh next env && fresh next l then
            slope next a (function_value (Pos.succ next) env g (set k (At next) l))
          else None
      | None => None
      end
  | Unknown j => Some (Jet j (map (fun _ => O) l) l, [])
  end.
Definition values (next : positive) (env : list ex) : list term -> option (list ex * list ex) :=
  fix values l := match l with
  | [] => Some ([], [])
  | a :: l' => match value next env a, values l' with
      | Some (x, c), Some (xs, d) => Some (normal x :: xs, c ++ d)
      | _, _ => None end end.

Variable Phi : list (list R -> R).
Hypothesis smooth_functions : smooth_all smoothness Phi.

Notation nonzero := (nonzero Phi).

Lemma inverted_value rho e : eval Phi rho (inverted e) = / eval Phi rho e.
Proof.
  induction e; simpl; trivial.
  - now rewrite IHe1, IHe2, Rinv_mult.
  - now rewrite IHe, Rinv_opp.
  - now rewrite IHe, pow_inv.
  - now rewrite Rinv_inv.
Qed.

Lemma nonzero_app rho c d : nonzero rho (c ++ d) -> nonzero rho c /\ nonzero rho d.
Proof. apply Forall_app. Qed.

Lemma fresh_map rho x t l : fresh x l = true -> map (eval Phi (update rho x t))
  l = map (eval Phi rho) l.
Proof.
  unfold fresh. intro h. apply negb_true_iff, existsb_false in h. apply map_eq. revert h.
    apply Forall_impl.
  intros a h. now apply eval_update.
Qed.
Lemma map_set {A B} (f : A -> B) a l : forall k, map f (set k a l) = set k (f a) (map f l).
Proof. induction l as [|b l IH]; intros [|k]; simpl; trivial. now rewrite IH. Qed.
Lemma fresh_set rho x t l k : fresh x l = true ->
  map (eval Phi (update rho x t)) (set k (At x) l) = set k t (map (eval Phi rho) l).
Proof. intro h. rewrite map_set, fresh_map by trivial. cbn [eval]. now rewrite update_self. Qed.

(* What is different from 0 at t is different from 0 near t. *)
Lemma nonzero_near rho x t c : forallb (differentiable smoothness x) c = true ->
  nonzero (update rho x t) (flat_map (denominators x) c) -> nonzero (update rho x t) c ->
  locally t (fun s => nonzero (update rho x s) c).
Proof.
  intros h n z. induction c as [|d c IH].
  - apply filter_forall. intro. constructor.
  - simpl in h, n. apply andb_prop in h. destruct h as [h1 h2]. apply nonzero_app in n.
      destruct n as [n1 n2].
    inversion z as [|? ? z1 z2]; subst.
    assert (L : locally t (fun s => eval Phi (update rho x s) d <> 0)).
    { apply (expression_continuous smoothness Phi smooth_functions rho x d t h1 n1 (fun y => y <>
      0)). apply open_neq. exact z1. }
    generalize (filter_and _ _ L (IH h2 n2 z2)). apply filter_imp. intros s [l1 l2].
      now constructor.
Qed.

Lemma slope_value rho x a v e c (f : R -> R) :
  slope x a v = Some (e, c) -> nonzero rho c ->
  (forall y d, v = Some (y, d) -> forall t, nonzero (update rho x t) d ->
    f t = eval Phi (update rho x t) y) ->
  Derive f (eval Phi rho a) = eval Phi rho e.
Proof.
  unfold slope. destruct v as [[y d]|]; try discriminate.
  destruct (differentiable smoothness x (normal y) && forallb (differentiable smoothness x) d)
    eqn:E; try discriminate.
  intros [= <- <-] n h. apply andb_prop in E. destruct E as [E1 E2].
  set (t := eval Phi rho a).
  assert (n' : nonzero (update rho x t) (d ++ denominators x (normal y)
    ++ flat_map (denominators x) d)).
  { revert n. generalize (d ++ denominators x (normal y) ++ flat_map (denominators x) d).
    intros l n.
    unfold nonzero in *. rewrite Forall_map in n. revert n. apply Forall_impl. intros b z.
    now rewrite normal_value, eval_substitute in z. }
  apply nonzero_app in n'. destruct n' as [n1 n']. apply nonzero_app in n'. destruct n' as [n2 n3].
  rewrite normal_value, eval_substitute. fold t. apply is_derive_unique.
  apply is_derive_ext_loc with (fun s => eval Phi (update rho x s) (normal y)).
  - generalize (nonzero_near rho x t d E2 n3 n1). apply filter_imp. intros s z.
    rewrite normal_value. symmetry. now apply (h y d).
  - now apply (derivative_value Phi smoothness).
Qed.

Theorem value_correct t : forall next env rho e c, value next env t = Some (e, c) ->
  nonzero rho c ->
  denote Phi (map (eval Phi rho) env) t = eval Phi rho e.
Proof.
  revert t. apply (term_induction
    (fun t => forall next env rho e c, value next env t = Some (e, c) -> nonzero rho c ->
      denote Phi (map (eval Phi rho) env) t = eval Phi rho e)
    (fun f => forall next env l rho e c, function_value next env f l = Some (e, c) ->
      nonzero rho c ->
      denoteF Phi (map (eval Phi rho) env) f (map (eval Phi rho) l) = eval Phi rho e)).
  - intros z next env rho e c [= <- <-] _. now rewrite integer_value.
  - intros k next env rho e c h _. simpl in h. destruct (nth_error env k) eqn:E; try discriminate.
      injection h as <- <-.
    simpl. apply nth_error_nth. now apply map_nth_error.
  - intros a b ha hb next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate.
    destruct (value next env b) as [[y d']|] eqn:E'; try discriminate. injection h as <- <-.
    apply nonzero_app in n. destruct n. simpl. erewrite ha, hb by eassumption. reflexivity.
  - intros a b ha hb next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate.
    destruct (value next env b) as [[y d']|] eqn:E'; try discriminate. injection h as <- <-.
    apply nonzero_app in n. destruct n. simpl. erewrite ha, hb by eassumption. reflexivity.
  - intros a b ha hb next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate.
    destruct (value next env b) as [[y d']|] eqn:E'; try discriminate. injection h as <- <-.
    apply nonzero_app in n. destruct n. simpl. erewrite ha, hb by eassumption. reflexivity.
  - intros a ha next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate. injection h as <- <-.
    simpl. erewrite ha by eassumption. reflexivity.
  - intros a b ha hb next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate.
    destruct (value next env b) as [[y d']|] eqn:E'; try discriminate. injection h as <- <-.
    apply nonzero_app in n. destruct n. simpl. rewrite inverted_value.
      erewrite ha, hb by eassumption. reflexivity.
  - intros a m ha next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate. injection h as <- <-.
    simpl. erewrite ha by eassumption. reflexivity.
  - intros m i a ha next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate. injection h as <- <-.
    rewrite bernstein_value. simpl. erewrite ha by eassumption. reflexivity.
  - intros l p i s a ha next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate. injection h as <- <-.
    rewrite spline_value. simpl. erewrite ha by eassumption. reflexivity.
  - intros f l hf hl next env rho e c h n. 
    change (match values next env l with
      | Some (xs, c) => match function_value next env f xs with Some (y, d) => Some (y,
        c ++ d) | None => None end
      | None => None end = Some (e, c)) in h.
    destruct (values next env l) as [[xs d]|] eqn:E; try discriminate.
    destruct (function_value next env f xs) as [[y d']|] eqn:E'; try discriminate.
      injection h as <- <-.
    apply nonzero_app in n. destruct n as [n1 n2]. cbn [denote].
    replace (map (denote Phi (map (eval Phi rho) env)) l) with (map (eval Phi rho) xs);
      [eapply hf; eassumption|].
    clear - hl E n1. revert xs d E n1. induction hl as [|a l ha _ IH]; intros xs d E n; simpl in E.
    + injection E as <- <-. reflexivity.
    + destruct (value next env a) as [[x c]|] eqn:E1; try discriminate.
      destruct (values next env l) as [[ys c']|] eqn:E2; try discriminate. injection E as <- <-.
      apply nonzero_app in n. destruct n. simpl. rewrite normal_value.
        f_equal; [|eapply IH; trivial].
      symmetry. eapply ha; eassumption.
  - intros a b b' ha hb he next env rho e c h n. cbn [value] in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate.
    destruct (value next env b) as [[y d']|] eqn:E'; try discriminate.
    destruct (value (Pos.succ next) (At next :: env) b') as [[z [|? ?]]|] eqn:E2; try discriminate.
    destruct (fresh next env) eqn:F; try discriminate.
    destruct (integral smoothness next x y (normal z)) as [r|] eqn:I; try discriminate.
      injection h as <- <-.
    apply nonzero_app in n. destruct n. rewrite <- (integral_value smoothness Phi smooth_functions
      _ _ _ _ _ _ I). cbn [denote].
    erewrite ha, hb by eassumption. apply RInt_ext. intros t _. rewrite normal_value.
    rewrite <- (he _ _ (update rho next t) _ _ E2) by constructor.
    cbn [map eval]. now rewrite update_self, fresh_map.
  - intros a ha next env rho e c h n. simpl in h.
    destruct (value next env a) as [[x d]|] eqn:E; try discriminate. injection h as <- <-.
    simpl. erewrite ha by eassumption. reflexivity.
  - intros m b hb next env l rho e c h n. simpl in *. rewrite <- map_app. eapply hb; eassumption.
  - intros k g hg next env l rho e c h n. cbn [function_value] in h.
    destruct (nth_error l k) as [a|] eqn:E; try discriminate.
    destruct (fresh next env && fresh next l) eqn:F; try discriminate. apply andb_prop in F.
      destruct F as [F1 F2].
    cbn [denoteF]. replace (nth k (map (eval Phi rho) l) 0) with (eval Phi rho a).
    2:{ symmetry. apply nth_error_nth. now apply map_nth_error. }
    eapply slope_value; [exact h|exact n|]. intros y d V t z.
    rewrite <- (hg _ _ _ (update rho next t) _ _ V z). now rewrite fresh_set, fresh_map.
  - intros j next env l rho e c [= <- <-] _. simpl.
    assert (Z : forall (m : list ex) k f, jet k (map (fun _ => 0%nat) m) f = f) by (induction m;
      simpl; auto).
    now rewrite Z.
Qed.
End Value.
