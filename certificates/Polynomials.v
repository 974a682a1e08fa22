(* Polynomials with rational coefficients in Horner form: EnvRing of the standard library at Q, with every
   coefficient reduced.  Variables are positive numbers. *)
Require Import Reals QArith Qreals Qreduction ZArith Lia.
Require Import micromega.Env micromega.EnvRing micromega.RMicromega.
Local Open Scope R_scope.

Notation poly := (Pol Q).
Definition qadd a b := Qred (Qplus a b).
Definition qmul a b := Qred (Qmult a b).
Definition qsub a b := Qred (Qminus a b).

Definition constant (c : Q) : poly := Pc c.
Definition indeterminate (p : positive) : poly := mk_X 0%Q 1%Q p.
Definition padd : poly -> poly -> poly := Padd 0%Q qadd Qeq_bool.
Definition psub : poly -> poly -> poly := Psub 0%Q qadd qsub Qopp Qeq_bool.
Definition pmul : poly -> poly -> poly := Pmul 0%Q 1%Q qadd qmul Qeq_bool.
Definition popp : poly -> poly := Popp Qopp.
Fixpoint ppow (p : poly) (n : nat) : poly :=
  match n with O => constant 1 | S O => p | S n' => pmul p (ppow p n') end.
Definition same (p q : poly) : bool := Peq Qeq_bool p q.

(* The value of a polynomial. *)
Definition pvalue (env : positive -> R) (p : poly) : R := Pphi Rplus Rmult Q2R env p.

Lemma ring_extension : ring_eq_ext Rplus Rmult Ropp (@eq R).
Proof. constructor; repeat intro; subst; reflexivity. Qed.
Lemma rational_morphism :
  ring_morph R0 R1 Rplus Rmult Rminus Ropp (@eq R) 0%Q 1%Q qadd qmul qsub Qopp Qeq_bool Q2R.
Proof.
  constructor.
  - apply Q2R_0.
  - apply Q2R_1.
  - intros; unfold qadd. rewrite <- Q2R_plus. apply Qeq_eqR, Qred_correct.
  - intros; unfold qsub. rewrite <- Q2R_minus. apply Qeq_eqR, Qred_correct.
  - intros; unfold qmul. rewrite <- Q2R_mult. apply Qeq_eqR, Qred_correct.
  - intros; apply Q2R_opp.
  - intros; now apply Qeq_true.
Qed.
Lemma real_ring : almost_ring_theory R0 R1 Rplus Rmult Rminus Ropp (@eq R).
Proof. apply (Rth_ARth (Eqsth R) ring_extension Rsrt). Qed.

Section Values.
Variable env : positive -> R.
Lemma constant_value c : pvalue env (constant c) = Q2R c.
Proof. reflexivity. Qed.
Lemma indeterminate_value p : pvalue env (indeterminate p) = env p.
Proof. symmetry. apply (mkX_ok (Eqsth R) ring_extension real_ring rational_morphism). Qed.
Lemma padd_value p q : pvalue env (padd p q) = pvalue env p + pvalue env q.
Proof. apply (Padd_ok (Eqsth R) ring_extension real_ring rational_morphism). Qed.
Lemma psub_value p q : pvalue env (psub p q) = pvalue env p - pvalue env q.
Proof. apply (Psub_ok (Eqsth R) ring_extension real_ring rational_morphism). Qed.
Lemma pmul_value p q : pvalue env (pmul p q) = pvalue env p * pvalue env q.
Proof. apply (Pmul_ok (Eqsth R) ring_extension real_ring rational_morphism). Qed.
Lemma popp_value p : pvalue env (popp p) = - pvalue env p.
Proof. apply (Popp_ok (Eqsth R) ring_extension real_ring rational_morphism). Qed.
Lemma ppow_value p n : pvalue env (ppow p n) = pvalue env p ^ n.
Proof.
  induction n as [|[|n] IH].
  - apply Q2R_1.
  - symmetry. apply pow_1.
  - change (ppow p (S (S n))) with (pmul p (ppow p (S n))). now rewrite pmul_value, IH.
Qed.
Lemma same_value p q : same p q = true -> pvalue env p = pvalue env q.
Proof. intro h. apply (Peq_ok (Eqsth R) ring_extension rational_morphism _ _ h). Qed.

(* One step of Horner's rule, with the variables counted on from position j. *)
Lemma pvalue_PX l p i q :
  pvalue l (PX p i q) = pvalue l p * Env.hd l ^ Pos.to_nat i + pvalue (Env.tail l) q.
Proof.
  unfold pvalue. simpl. f_equal. f_equal.
  assert (h : forall x i, pow_pos Rmult x i = x ^ Pos.to_nat i); [|apply h].
  clear. intros x i. induction i as [i IH|i IH|]; simpl pow_pos.
  - rewrite Pos2Nat.inj_xI. simpl. rewrite <- plus_n_O, pow_add, IH. ring.
  - rewrite Pos2Nat.inj_xO. simpl. rewrite <- plus_n_O, pow_add, IH. ring.
  - simpl. ring.
Qed.
End Values.
