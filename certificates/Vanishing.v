(* Is an expression zero, or never zero, given that others are different from zero? *)
Require Import QArith Qreals Lra micromega.EnvRing.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Fractions.
Local Open Scope R_scope.

(* The coefficient that comes first in a polynomial. *)
Fixpoint lead (p : poly) : Q :=
  match p with Pc c => c | Pinj _ q => lead q | PX q _ _ => lead q end.

(* Facts "p <> 0" are pairs (m, r) with r <> 0; a polynomial p is different from 0 when m p = r, or
   when these differ by a number only. *)
Definition polynomial_of (T : list ex) (e : ex) : option poly :=
  match divisors T e, as_fraction T e with [], (p, []) => Some p | _, _ => None end.
Definition shown_nonzero (T : list ex) (K : list (ex * ex)) (p : poly) : bool :=
  existsb (fun f => match polynomial_of T (fst f), polynomial_of T (snd f) with
    | Some m, Some r =>
        let q := pmul m p in
        negb (Qeq_bool (lead q) 0)
        && same (pmul (constant (lead r)) q) (pmul (constant (lead q)) r)
    | _, _ => false end) K.
Definition clear (T : list ex) (K : list (ex * ex)) (e : ex) : bool :=
  forallb (shown_nonzero T K) (divisors T e).
Definition table_for (K : list (ex * ex)) (e : ex) : list ex :=
  table (inner_atoms e ++ flat_map (fun f => inner_atoms (fst f) ++ inner_atoms (snd f)) K).
(* Is e zero, respectively different from zero, provided the facts K? *)
Definition vanishes (K : list (ex * ex)) (e : ex) : bool :=
  let T := table_for K e in same (fst (as_fraction T e)) (constant 0) && clear T K e.
Definition never_zero (K : list (ex * ex)) (e : ex) : bool :=
  let T := table_for K e in
  let p := fst (as_fraction T e) in
  match unit_inverse p with Some _ => true | None => shown_nonzero T K p end && clear T K e.

Section Checks.
Variable Phi : list (list R -> R).
Variable rho : positive -> R.
Variable K : list (ex * ex).
Hypothesis known : Forall (fun f => eval Phi rho (snd f) <> 0) K.

Lemma own_atoms e : Forall (fun a => In a (table_for K e)) (inner_atoms e).
Proof.
  rewrite Forall_forall. intros a h. apply in_table, in_or_app. now left.
Qed.
Lemma known_atoms e f : In f K -> Forall (fun a => In a (table_for K e)) (inner_atoms (fst f)
  ++ inner_atoms (snd f)).
Proof.
  intro i. rewrite Forall_forall. intros a h. apply in_table, in_or_app. right. apply in_flat_map.
    now exists f.
Qed.
Lemma polynomial_of_value T e p : Forall (fun a => In a T) (inner_atoms e) ->
  polynomial_of T e = Some p ->
  pvalue (places Phi rho T) p = eval Phi rho e.
Proof.
  unfold polynomial_of. intros h E. destruct (divisors T e) eqn:D; try discriminate.
  destruct (as_fraction_value Phi rho T e h) as [v _]; [rewrite D; constructor|].
  destruct (as_fraction T e) as [q [|? ?]]; try discriminate. injection E as <-. simpl in v. lra.
Qed.
Lemma shown_nonzero_value e p : shown_nonzero (table_for K e) K p = true ->
  pvalue (places Phi rho (table_for K e)) p <> 0.
Proof.
  unfold shown_nonzero. intro h. apply existsb_exists in h. destruct h as [f [i h]].
  pose proof (known_atoms e f i) as A. apply Forall_app in A. destruct A as [A1 A2].
  destruct (polynomial_of (table_for K e) (fst f)) as [m|] eqn:M; try discriminate.
  destruct (polynomial_of (table_for K e) (snd f)) as [r|] eqn:E; try discriminate.
  cbv zeta in h. set (q := pmul m p) in h. apply andb_prop in h. destruct h as [n h].
  apply (same_value (places Phi rho (table_for K e))) in h.
  rewrite !pmul_value, !constant_value, (polynomial_of_value _ _ _ A2 E) in h.
  unfold q in h at 1. rewrite pmul_value in h.
  rewrite Forall_forall in known. specialize (known f i). intro z. rewrite z, !Rmult_0_r in h.
  symmetry in h. apply Rmult_integral in h. destruct h as [h|h]; [|now apply known].
  apply negb_true_iff in n. apply Qeq_bool_neq in n. apply n. apply eqR_Qeq.
  now rewrite h, zero_value.
Qed.
Lemma clear_value e : clear (table_for K e) K e = true ->
  nonzero_polys Phi rho (table_for K e) (divisors (table_for K e) e).
Proof.
  unfold clear. rewrite forallb_forall. intro h. unfold nonzero_polys. rewrite Forall_forall.
    intros p i.
  now apply shown_nonzero_value, h.
Qed.
Theorem vanishes_correct e : vanishes K e = true -> eval Phi rho e = 0.
Proof.
  unfold vanishes. intro h. apply andb_prop in h. destruct h as [h1 h2]. apply clear_value in h2.
  destruct (as_fraction_value Phi rho _ e (own_atoms e) h2) as [v n].
  apply (same_value (places Phi rho (table_for K e))) in h1.
    rewrite h1, constant_value, zero_value in v.
  apply nonzero_product in n. now apply Rmult_integral in v as [v|v].
Qed.
Theorem never_zero_correct e : never_zero K e = true -> eval Phi rho e <> 0.
Proof.
  unfold never_zero. intro h. apply andb_prop in h. destruct h as [h1 h2]. apply clear_value in h2.
  destruct (as_fraction_value Phi rho _ e (own_atoms e) h2) as [v n]. intro z.
    rewrite z, Rmult_0_l in v.
  destruct (unit_inverse _) as [q|] eqn:E.
  - apply (unit_inverse_value Phi rho (table_for K e)) in E. destruct E as [_ E]. apply E.
      now symmetry.
  - apply shown_nonzero_value in h1. apply h1. now symmetry.
Qed.
End Checks.
