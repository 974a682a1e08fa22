(* Normal forms of expressions: equal polynomials in equal atoms become the same expression. *)
Require Import QArith Qreals Qreduction Lia micromega.EnvRing.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Local Open Scope R_scope.

(* The atoms of the polynomial e, in order and each once. *)
Fixpoint atoms (e : ex) : list ex :=
  match e with
  | Num _ | At _ => []
  | Plus a b | Minus a b | Times a b => atoms a ++ atoms b
  | Negate a | Power a _ => atoms a
  | _ => [e]
  end.
Fixpoint insert (a : ex) (l : list ex) : list ex :=
  match l with
  | [] => [a]
  | b :: l' => match compare a b with Eq => l | Lt => a :: l | Gt => b :: insert a l' end
  end.
Definition table (l : list ex) : list ex := fold_right insert [] l.

Lemma in_insert a b l : b = a \/ In b l -> In b (insert a l).
Proof.
  induction l as [|c l IH]; simpl; [intuition|]. destruct (compare a c) eqn:E; simpl; intuition.
  subst. left. symmetry. now apply compare_eq.
Qed.
Lemma in_table a l : In a l -> In a (table l).
Proof. induction l as [|b l IH]; simpl; [easy|]. intro h. apply in_insert. intuition. Qed.

(* The place of an atom in the table, and the atom at a place; places are counted from p. *)
Fixpoint place (a : ex) (T : list ex) (p : positive) : positive :=
  match T with [] => p | b :: T' => if equal a b then p else place a T' (Pos.succ p) end.
Fixpoint atom_at (T : list ex) (p q : positive) : ex :=
  match T with [] => Num 0 | b :: T' => if Pos.eqb p q then b else atom_at T' (Pos.succ p) q end.
Definition first : positive := 1024.

Lemma place_ge a T : forall p, (p <= place a T p)%positive.
Proof. induction T as [|b T IH]; intro p; simpl; [lia|]. destruct (equal a b); [lia|].
  specialize (IH (Pos.succ p)). lia. Qed.
Lemma equal_refl a : equal a a = true.
Proof.
  assert (L : forall {A} (f : A -> A -> comparison) l, Forall (fun a => f a a = Eq) l ->
    compare_lists f l l = Eq).
  { intros A f l h. induction h as [|x l e _ IH]; simpl; [trivial|]. now rewrite e. }
  assert (H : compare a a = Eq); [|unfold equal; now rewrite H].
  induction a using ex_induction; simpl; trivial;
    try (rewrite IHa1; exact IHa2); try (now rewrite ?Nat.compare_refl).
  - unfold compare_rationals. rewrite Z.compare_refl. apply Pos.compare_refl.
  - apply Pos.compare_refl.
  - rewrite Nat.compare_refl, !L; trivial. rewrite Forall_forall; intros; apply Nat.compare_refl.
Qed.
Lemma atom_place a T : In a T -> forall p, atom_at T p (place a T p) = a.
Proof.
  induction T as [|b T IH]; intros i p; simpl in *; [easy|].
  destruct (equal a b) eqn:E.
  - rewrite Pos.eqb_refl. symmetry. now apply equal_eq.
  - destruct (Pos.eqb_spec p (place a T (Pos.succ p))) as [e|_].
    + pose proof (place_ge a T (Pos.succ p)). lia.
    + apply IH. destruct i as [<-|i]; [|exact i]. now rewrite equal_refl in E.
Qed.

(* Variables have even places, atoms odd ones behind the variables. *)
Fixpoint polynomial (T : list ex) (e : ex) : poly :=
  match e with
  | Num q => constant q
  | At p => indeterminate (xO p)
  | Plus a b => padd (polynomial T a) (polynomial T b)
  | Minus a b => psub (polynomial T a) (polynomial T b)
  | Times a (At p) => shift 1 (polynomial T a) (xO p)
  | Times a (Power (At p) (S n)) => shift (Pos.of_succ_nat n) (polynomial T a) (xO p)
  | Times a b => pmul (polynomial T a) (polynomial T b)
  | Negate a => popp (polynomial T a)
  | Power a n => ppow (polynomial T a) n
  | _ => indeterminate (xI (place e T first))
  end.
Definition variable (T : list ex) (j : positive) : ex :=
  match j with xO p => At p | xI p => atom_at T first p | xH => Num 0 end.

Definition plus (a b : ex) : ex := match b with Num (0 # _) => a | _ => Plus a b end.
Definition times (a b : ex) : ex := match a with Num (1 # 1) => b | _ => Times a b end.
Definition power (a : ex) (n : positive) : ex := match n with xH => a | _ => Power a (Pos.to_nat n)
  end.
(* The expression of a polynomial whose variables are counted from place j. *)
Fixpoint expression (T : list ex) (j : positive) (p : poly) : ex :=
  match p with
  | Pc c => Num c
  | Pinj k p => expression T (j + k) p
  | PX p i q => plus (times (expression T j p) (power (variable T j) i))
    (expression T (Pos.succ j) q)
  end.

Section Values.
Variable Phi : list (list R -> R).
Variable rho : positive -> R.
Notation eval := (eval Phi rho).

Definition places (T : list ex) (j : positive) : R := eval (variable T j).

Lemma zero_value : Q2R 0 = 0. Proof. apply RMicromega.Q2R_0. Qed.
Lemma one_value : Q2R 1 = 1. Proof. apply RMicromega.Q2R_1. Qed.
Lemma polynomial_value T e : Forall (fun a => In a T) (atoms e) ->
  pvalue (places T) (polynomial T e) = eval e.
Proof.
  assert (A : forall a, Forall (fun a => In a T) [a] ->
    pvalue (places T) (indeterminate (xI (place a T first))) = eval a).
  { intros a h. inversion h; subst. rewrite indeterminate_value. unfold places. cbn [variable].
    now rewrite atom_place. }
  assert (M : forall a b, polynomial T (Times a b) = pmul (polynomial T a) (polynomial T b) \/
    (exists p n, polynomial T (Times a b) = shift (Pos.of_succ_nat n) (polynomial T a) (xO p) /\
      eval b = rho p ^ S n)).
  { intros a b. destruct b as [|p| | | | |[|p| | | | | | | |] [|n]| | |]; try (now left); right.
    - exists p, 0%nat. split; trivial. simpl. ring.
    - now exists p, n. }
  induction e; cbn [atoms]; intro h; try (now apply A);
    try (destruct (M e1 e2) as [->|[p [n [-> E]]]];
      [|apply Forall_app in h; destruct h as [h1 h2]; rewrite shift_value, IHe1,
        SuccNat2Pos.id_succ by trivial;
        cbn [Expressions.eval]; now rewrite E]); cbn [polynomial];
    try (apply Forall_app in h; destruct h as [h1 h2]);
    rewrite ?padd_value, ?psub_value, ?pmul_value, ?popp_value, ?ppow_value, ?indeterminate_value;
    simpl; try rewrite IHe1 by trivial; try rewrite IHe2 by trivial; try rewrite IHe by trivial;
      reflexivity.
Qed.
Lemma plus_value a b : eval (plus a b) = eval a + eval b.
Proof.
  destruct b as [[[| |] d]| | | | | | | | |]; trivial. simpl. unfold Q2R; simpl. ring.
Qed.
Lemma times_value a b : eval (times a b) = eval a * eval b.
Proof.
  destruct a as [[[|[| |]|] [| |]]| | | | | | | | |]; trivial. simpl. unfold Q2R; simpl. field.
Qed.
Lemma power_value a n : eval (power a n) = eval a ^ Pos.to_nat n.
Proof. destruct n; trivial. simpl. ring. Qed.
Lemma expression_value T p : forall j l, (forall x, l x = places T (Pos.pred (x + j))) ->
  eval (expression T j p) = pvalue l p.
Proof.
  induction p as [c|k p IH|p IHp i q IHq]; intros j l h; simpl expression.
  - reflexivity.
  - apply IH. intro x. unfold Env.jump. rewrite h. f_equal. lia.
  - rewrite plus_value, times_value, power_value, pvalue_PX, (IHp j l h),
      (IHq (Pos.succ j) (Env.tail l)).
    + f_equal. f_equal. unfold Env.hd, Env.nth. rewrite h.
        replace (Pos.pred (1 + j)) with j by lia. reflexivity.
    + intro x. unfold Env.tail, Env.jump. rewrite h. f_equal. lia.
Qed.
End Values.

(* The normal form of an expression with normal atoms. *)
Definition collected (e : ex) : ex := let T := table (atoms e) in expression T 1 (polynomial T e).
Definition inverse (a : ex) : ex :=
  match a with Num q => if Qeq_bool q 0 then Inverse a else Num (Qred (/ q)) | _ => Inverse a end.
Fixpoint with_normal_atoms (e : ex) : ex :=
  match e with
  | Num _ | At _ => e
  | Plus a b => Plus (with_normal_atoms a) (with_normal_atoms b)
  | Minus a b => Minus (with_normal_atoms a) (with_normal_atoms b)
  | Times a b => Times (with_normal_atoms a) (with_normal_atoms b)
  | Negate a => Negate (with_normal_atoms a)
  | Power a n => Power (with_normal_atoms a) n
  | Jet j o l => Jet j o (map (fun a => collected (with_normal_atoms a)) l)
  | Inverse a => inverse (collected (with_normal_atoms a))
  | Root a => Root (collected (with_normal_atoms a))
  end.
Definition normal (e : ex) : ex := collected (with_normal_atoms e).

Section Correctness.
Variable Phi : list (list R -> R).
Variable rho : positive -> R.
Notation eval := (eval Phi rho).
Lemma in_own_table l : Forall (fun a => In a (table l)) l.
Proof. rewrite Forall_forall. intros a h. now apply in_table. Qed.
Lemma collected_value e : eval (collected e) = eval e.
Proof.
  unfold collected. rewrite (expression_value _ _ _ _ _ (places Phi rho (table (atoms e)))).
  - apply polynomial_value, in_own_table.
  - intro x. f_equal. lia.
Qed.
Lemma inverse_value a : eval (inverse a) = / eval a.
Proof.
  destruct a; trivial. simpl. destruct (Qeq_bool q 0) eqn:E; trivial. simpl.
  rewrite (Qeq_eqR _ _ (Qred_correct _)). apply Q2R_inv. now apply Qeq_bool_neq.
Qed.
Lemma with_normal_atoms_value e : eval (with_normal_atoms e) = eval e.
Proof.
  induction e using ex_induction; simpl; try congruence.
  - f_equal. rewrite map_map. apply map_eq. revert H. apply Forall_impl. intros a h.
      now rewrite collected_value.
  - now rewrite inverse_value, collected_value, IHe.
  - now rewrite collected_value, IHe.
Qed.
Theorem normal_value e : eval (normal e) = eval e.
Proof. unfold normal. now rewrite collected_value, with_normal_atoms_value. Qed.
End Correctness.
