(* Polynomials with rational coefficients in Horner form: EnvRing of the standard library at Q,
  with every
   coefficient reduced.  Variables are positive numbers. *)
Require Import Reals QArith Qreals Qreduction ZArith Lia FunctionalExtensionality.
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
Definition psquare : poly -> poly := Psquare 0%Q 1%Q qadd qmul Qeq_bool.
Fixpoint ppow (p : poly) (n : nat) : poly :=
  match n with O => constant 1 | S O => p | S (S O) => psquare p | S n' => pmul p (ppow p n') end.
(* p times the i-th power of the variable j; nothing is multiplied out. *)
Fixpoint shift (i : positive) (p : poly) (j : positive) : poly :=
  match p with
  | Pc c =>
      if Qeq_bool c 0 then p
      else match j with xH => PX p i (Pc 0%Q) | _ => Pinj (Pos.pred j) (PX p i (Pc 0%Q)) end
  | Pinj k q =>
      match Pos.compare j k with
      | Gt => mkPinj k (shift i q (j - k))
      | _ => match j with
          | xH => PX p i (Pc 0%Q)
          | _ => Pinj (Pos.pred j) (PX (Pinj (k - Pos.pred j) q) i (Pc 0%Q)) end
      end
  | PX a n b =>
      match j with
      | xH => mkPX 0%Q Qeq_bool p i (Pc 0%Q)
      | _ => mkPX 0%Q Qeq_bool (shift i a j) n (shift i b (Pos.pred j))
      end
  end.
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

Lemma power_of_positive x i : pow_pos Rmult x i = x ^ Pos.to_nat i.
Proof.
  induction i as [i IH|i IH|]; simpl pow_pos.
  - rewrite Pos2Nat.inj_xI. simpl. rewrite <- plus_n_O, pow_add, IH. ring.
  - rewrite Pos2Nat.inj_xO. simpl. rewrite <- plus_n_O, pow_add, IH. ring.
  - simpl. ring.
Qed.

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
Lemma psquare_value p : pvalue env (psquare p) = pvalue env p * pvalue env p.
Proof. apply (Psquare_ok (Eqsth R) ring_extension real_ring rational_morphism). Qed.
Lemma ppow_value p n : pvalue env (ppow p n) = pvalue env p ^ n.
Proof.
  induction n as [|[|[|n]] IH].
  - apply Q2R_1.
  - symmetry. apply pow_1.
  - change (ppow p 2) with (psquare p). rewrite psquare_value. ring.
  - change (ppow p (S (S (S n)))) with (pmul p (ppow p (S (S n)))). now rewrite pmul_value, IH.
Qed.
Lemma same_value p q : same p q = true -> pvalue env p = pvalue env q.
Proof. intro h. apply (Peq_ok (Eqsth R) ring_extension rational_morphism _ _ h). Qed.

(* One step of Horner's rule, with the variables counted on from position j. *)
Lemma pvalue_PX l p i q :
  pvalue l (PX p i q) = pvalue l p * Env.hd l ^ Pos.to_nat i + pvalue (Env.tail l) q.
Proof.
  unfold pvalue. simpl. f_equal. f_equal. apply power_of_positive.
Qed.
End Values.

Lemma mkPX_value l p i q :
  pvalue l (mkPX 0%Q Qeq_bool p i q) = pvalue l p * Env.hd l ^ Pos.to_nat i + pvalue (Env.tail l) q.
Proof.
  rewrite <- power_of_positive. apply (mkPX_ok (Eqsth R) ring_extension real_ring
    rational_morphism).
Qed.
Lemma mkPinj_value l k p : pvalue l (mkPinj k p) = pvalue (Env.jump k l) p.
Proof. apply (mkPinj_ok _ _ (Eqsth R)). Qed.
Lemma zero_polynomial l : pvalue l (Pc 0%Q) = 0.
Proof. apply Q2R_0. Qed.
Lemma jump_at (k j : positive) (l : positive -> R) : Env.jump k l j = l (j + k)%positive.
Proof. reflexivity. Qed.
Lemma jump_jump (a b c : positive) (l : positive -> R) : (a + b)%positive = c ->
  Env.jump a (Env.jump b l) = Env.jump c l.
Proof. intros <-. apply functional_extensionality. intro x. rewrite !jump_at. f_equal. lia. Qed.
Lemma shift_value i p : forall j l, pvalue l (shift i p j) = pvalue l p * l j ^ Pos.to_nat i.
Proof.
  assert (here : forall q l, pvalue l (PX q i (Pc 0%Q)) = pvalue l q * l 1%positive ^ Pos.to_nat i).
  { intros q l. rewrite pvalue_PX, zero_polynomial. unfold Env.hd, Env.nth. ring. }
  assert (there : forall q k l, pvalue l (Pinj k q) = pvalue (Env.jump k l) q) by reflexivity.
  assert (past : forall q j l, j <> 1%positive -> pvalue l (Pinj (Pos.pred j) (PX q i (Pc 0%Q)))
    = pvalue (Env.jump (Pos.pred j) l) q * l j ^ Pos.to_nat i).
  { intros q j l h. rewrite there, here, jump_at. do 3 f_equal. lia. }
  assert (case : forall (j : positive) (x y : poly), j = 1%positive /\ match j with xH => x | _ =>
    y end = x \/
    j <> 1%positive /\ match j with xH => x | _ => y end = y).
  { intros [j|j|] x y; [right|right|left]; split; trivial; discriminate. }
  induction p as [c|k q IH|a IHa n b IHb]; intros j l; cbn [shift].
  - destruct (Qeq_bool c 0) eqn:E.
    + apply Qeq_bool_eq in E. change (Q2R c = Q2R c * l j ^ Pos.to_nat i).
        rewrite (Qeq_eqR _ _ E), Q2R_0. ring.
    + destruct (case j (PX (Pc c) i (Pc 0%Q)) (Pinj (Pos.pred j) (PX (Pc c) i (Pc 0%Q))))
        as [[h ->]|[h ->]].
      * rewrite here. now rewrite h.
      * now rewrite past.
  - assert (low : (j <= k)%positive -> pvalue l match j with xH => PX (Pinj k q) i (Pc 0%Q)
        | _ => Pinj (Pos.pred j) (PX (Pinj (k - Pos.pred j) q) i (Pc 0%Q)) end
      = pvalue l (Pinj k q) * l j ^ Pos.to_nat i).
    { intro le. destruct (case j (PX (Pinj k q) i (Pc 0%Q)) (Pinj (Pos.pred j)
      (PX (Pinj (k - Pos.pred j) q) i (Pc 0%Q))))
        as [[h ->]|[h ->]].
      - rewrite here. now rewrite h.
      - rewrite past by exact h. rewrite !there, (jump_jump _ _ k); trivial. lia. }
    destruct (Pos.compare_spec j k) as [e|e|e]; try (apply low; lia).
    rewrite mkPinj_value, IH, there, jump_at. do 3 f_equal. lia.
  - destruct (case j (mkPX 0%Q Qeq_bool (PX a n b) i (Pc 0%Q)) (mkPX 0%Q Qeq_bool (shift i a j)
      n (shift i b (Pos.pred j))))
      as [[h ->]|[h ->]].
    + rewrite mkPX_value, zero_polynomial, h. unfold Env.hd, Env.nth. ring.
    + rewrite mkPX_value, IHa, IHb, pvalue_PX. unfold Env.tail. rewrite jump_at.
      replace (Pos.pred j + 1)%positive with j by lia. ring.
Qed.
