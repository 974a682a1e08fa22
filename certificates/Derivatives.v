(* The formal derivative of an expression in a variable. *)
Require Import QArith Qreals Lia.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Jets.
Local Open Scope R_scope.

Definition natural (n : nat) : ex := Num (inject_Z (Z.of_nat n)).
(* Sums and products without the terms that are visibly 0;
  numbers go to the coefficient, for then the normal
   form is found quickly. *)
Definition added (a b : ex) : ex :=
  match a, b with
  | Num (0 # _), _ => b
  | _, Num (0 # _) => a
  | _, _ => Plus a b
  end.
Definition multiplied (a b : ex) : ex :=
  match a, b with
  | Num (0 # _), _ => Num 0
  | _, Num (0 # _) => Num 0
  | Num (1 # 1), _ => b
  | _, Times (Num q) c => Times (Times a (Num q)) c
  | _, _ => Times a b
  end.
Fixpoint derivative (x : positive) (e : ex) : ex :=
  match e with
  | Num _ => Num 0
  | At p => if Pos.eqb p x then Num 1 else Num 0
  | Plus a b => added (derivative x a) (derivative x b)
  | Minus a b => Minus (derivative x a) (derivative x b)
  | Times a b => added (multiplied (derivative x a) b) (multiplied a (derivative x b))
  | Negate a => Negate (derivative x a)
  | Power a n => match n with
      | O => Num 0
      | S n' => multiplied (multiplied (derivative x a) (natural n)) (Power a n') end
  | Jet j o l =>
      if existsb (occurs x) l then
        (fix slopes k m := match m with
          | [] => Num 0
          | a :: m' => added (multiplied (Jet j (bump k o) l) (derivative x a)) (slopes (S k) m')
            end) 0%nat l
      else Num 0
  | Inverse a => if occurs x a then Times (Negate (derivative x a)) (Power (Inverse a) 2) else Num 0
  | Root a => Num 0
  end.

(* May e be differentiated in x?  S says how smooth the unknown functions are. *)
Fixpoint differentiable (S : list (nat * nat)) (x : positive) (e : ex) : bool :=
  match e with
  | Num _ | At _ => true
  | Plus a b | Minus a b | Times a b => differentiable S x a && differentiable S x b
  | Negate a | Power a _ | Inverse a => differentiable S x a
  | Jet j o l =>
      if existsb (occurs x) l then
        differentiable_jet (nth j S (0, 0)%nat) o && Nat.eqb (length l) (length o) &&
        forallb (differentiable S x) l
      else true
  | Root a => negb (occurs x a)
  end.
(* The denominators that depend on x; where they are different from 0,
  e has the formal derivative. *)
Fixpoint denominators (x : positive) (e : ex) : list ex :=
  match e with
  | Num _ | At _ => []
  | Plus a b | Minus a b | Times a b => denominators x a ++ denominators x b
  | Negate a | Power a _ | Root a => denominators x a
  | Jet _ _ l => flat_map (denominators x) l
  | Inverse a => if occurs x a then a :: denominators x a else []
  end.

Lemma is_derive_equal (f : R -> R) (t d d' : R) : is_derive f t d -> d = d' -> is_derive f t d'.
Proof. now intros h <-. Qed.

Section Correctness.
Variable Phi : list (list R -> R).
Variable smoothness : list (nat * nat).
Hypothesis smooth_functions : smooth_all smoothness Phi.
Variable rho : positive -> R.
Variable x : positive.
Notation at_ t := (eval Phi (update rho x t)).

Lemma zero_numerator d : Q2R (0 # d) = 0.
Proof. unfold Q2R. simpl. ring. Qed.
Lemma added_value r a b : eval Phi r (added a b) = eval Phi r a + eval Phi r b.
Proof.
  unfold added. destruct a as [[[|p|p] d]| | | | | | | | |], b as [[[|q|q] d']| | | | | | | | |];
    trivial; cbn [eval]; rewrite ?zero_numerator; ring.
Qed.
Lemma multiplied_value r a b : eval Phi r (multiplied a b) = eval Phi r a * eval Phi r b.
Proof.
  unfold multiplied.
  destruct a as [[[|[p|p|]|p] [d|d|]]| | | | | | | | |], b as [[[|q|q] d']| | | |[[[|q|q] d']| | |
    | | | | | |] b2| | | | |];
    trivial; cbn [eval]; rewrite ?zero_numerator, ?zero_value; try ring;
    replace (Q2R (1 # 1)) with 1 by (symmetry; exact one_value); ring.
Qed.
Lemma natural_value n r : eval Phi r (natural n) = INR n.
Proof. simpl. unfold Q2R, inject_Z; simpl. rewrite INR_IZR_INZ. field. Qed.
Lemma constant_derivative e t : occurs x e = false -> is_derive (fun t => at_ t e) t 0.
Proof.
  intro h. apply is_derive_ext with (fun _ => eval Phi rho e).
  - intro s. symmetry. now apply eval_update.
  - apply @is_derive_const.
Qed.
Lemma no_argument t l : existsb (occurs x) l = false -> map (at_ t) l = map (eval Phi rho) l.
Proof.
  intro h. apply map_eq. apply existsb_false in h. revert h. apply Forall_impl. intros a h.
    now apply eval_update.
Qed.
Lemma Forall_flat_map {A B} (P : B -> Prop) (f : A -> list B) l :
  Forall P (flat_map f l) -> Forall (fun a => Forall P (f a)) l.
Proof. induction l as [|a l IH]; simpl; intro h; constructor; apply Forall_app in h; destruct h;
  auto. Qed.

Theorem derivative_value e t :
  differentiable smoothness x e = true -> Forall (fun d => at_ t d <> 0) (denominators x e) ->
  is_derive (fun t => at_ t e) t (at_ t (derivative x e)).
Proof.
  induction e using ex_induction; intros h nz; cbn [differentiable denominators] in h, nz.
  - simpl. rewrite zero_value. apply @is_derive_const.
  - cbn [derivative]. destruct (Pos.eqb p x) eqn:E.
    + simpl. rewrite one_value. apply is_derive_ext with (fun t => t); [|apply @is_derive_id].
      intro s. unfold update. now rewrite E.
    + simpl (eval _ _ (Num 0)). rewrite zero_value. now apply constant_derivative.
  - apply andb_prop in h. destruct h. apply Forall_app in nz. destruct nz.
    cbn [derivative]. rewrite added_value. apply @is_derive_plus; auto.
  - apply andb_prop in h. destruct h. apply Forall_app in nz. destruct nz.
    apply @is_derive_minus; auto.
  - apply andb_prop in h. destruct h as [h1 h2]. apply Forall_app in nz. destruct nz as [n1 n2].
    cbn [derivative]. rewrite added_value, !multiplied_value.
    apply (is_derive_mult (fun t => at_ t e1) (fun t => at_ t e2)); auto.
  - apply @is_derive_opp; auto.
  - cbn [derivative]. destruct n as [|m].
    + simpl. rewrite zero_value. apply @is_derive_const.
    + rewrite !multiplied_value. change (is_derive (fun t => at_ t e ^ S m) t
        (at_ t (derivative x e) * eval Phi (update rho x t) (natural (S m)) * at_ t e ^ m)).
      rewrite natural_value.
      replace (at_ t (derivative x e) * INR (S m) * at_ t e ^ m)
        with (INR (S m) * at_ t (derivative x e) * at_ t e ^ pred (S m)) by (simpl pred; ring).
      apply is_derive_pow; auto.
  - cbn [derivative]. destruct (existsb (occurs x) l) eqn:E.
    + apply andb_prop in h. destruct h as [h h3]. apply andb_prop in h. destruct h as [h1 h2].
      apply Nat.eqb_eq in h2. rewrite forallb_forall in h3. apply Forall_flat_map in nz.
      pose proof (smooth_all_at _ _ j smooth_functions) as hs.
      assert (C : is_derive (fun t => at_ t (Jet j o l)) t
        (chain (unknown Phi j) o (map (at_ t) l) 0 (map (fun a => at_ t (derivative x a)) l))).
      { eapply is_derive_ext; [|replace (map (at_ t) l) with (map (fun a => a t)
        (map (fun a t => at_ t a) l));
          [apply (jet_chain _ _ o (map (fun a t => at_ t a) l) _ t hs h1)|]].
        - intro s. simpl. now rewrite map_map.
        - now rewrite map_length.
        - rewrite Forall_forall in H, nz. clear - H h3 nz.
          assert (K : forall a, In a l -> is_derive (fun t => at_ t a) t (at_ t (derivative x a)))
            by auto.
          clear - K. induction l as [|a l IH]; simpl in *; constructor; auto.
        - now rewrite map_map. }
      eapply is_derive_equal; [exact C|].
      assert (K : forall m k, chain (unknown Phi j) o (map (at_ t) l)
        k (map (fun a => at_ t (derivative x a)) m)
        = at_ t ((fix slopes k m := match m with
          | [] => Num 0
          | a :: m' => added (multiplied (Jet j (bump k o) l) (derivative x a)) (slopes (S k) m')
            end) k m)); [|apply K].
      intro m. induction m as [|a m IH]; intro k; [symmetry; apply zero_value|].
      cbn [map chain]. rewrite IH, added_value, multiplied_value. reflexivity.
    + simpl (eval _ _ (Num 0)). rewrite zero_value. apply constant_derivative. exact E.
  - cbn [derivative]. destruct (occurs x e) eqn:E.
    + inversion nz as [|? ? n1 n2]; subst.
      eapply is_derive_equal; [apply (is_derive_inv (fun t => at_ t e)); [apply IHe;
        trivial|exact n1]|].
      simpl. field. exact n1.
    + simpl (eval _ _ (Num 0)). rewrite zero_value. now apply constant_derivative.
  - simpl. rewrite zero_value. apply (constant_derivative (Root e)). simpl. now apply negb_true_iff.
Qed.
End Correctness.
