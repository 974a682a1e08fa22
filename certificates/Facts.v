(* Facts that certificates use as hypotheses. *)
Require Import ZArith Lia Lra Classical_Prop.
Require Import PatchProof.Definitions.
Local Open Scope R_scope.

(* Inequalities and the signs of differences. *)
Lemma le_difference (a b : R) : a <= b -> 0 <= b - a.
Proof. lra. Qed.
Lemma lt_difference (a b : R) : a < b -> 0 < b - a.
Proof. lra. Qed.
Lemma le_from_difference (a b : R) : 0 <= b - a -> a <= b.
Proof. lra. Qed.
Lemma lt_from_difference (a b : R) : 0 < b - a -> a < b.
Proof. lra. Qed.

(* Square roots of rational numbers. *)
Lemma root_square (z : Z) : Z.leb 0 z = true -> sqrt (IZR z) * sqrt (IZR z) = IZR z.
Proof. intro h. apply sqrt_sqrt. apply IZR_le. now apply Z.leb_le. Qed.
Lemma root_square_quotient (p q : Z) : Z.leb 0 p = true -> Z.ltb 0 q = true ->
  sqrt (IZR p / IZR q) * sqrt (IZR p / IZR q) = IZR p / IZR q.
Proof.
  intros hp hq. apply sqrt_sqrt. apply Z.leb_le, IZR_le in hp. apply Z.ltb_lt, IZR_lt in hq.
  apply Rmult_le_pos; trivial. now apply Rlt_le, Rinv_0_lt_compat.
Qed.
Lemma root_positive (z : Z) : Z.ltb 0 z = true -> 0 < sqrt (IZR z).
Proof. intro h. apply sqrt_lt_R0. apply IZR_lt. now apply Z.ltb_lt. Qed.
Lemma root_positive_quotient (p q : Z) : Z.ltb 0 p = true -> Z.ltb 0 q = true ->
  0 < sqrt (IZR p / IZR q).
Proof.
  intros hp hq. apply sqrt_lt_R0. apply Z.ltb_lt, IZR_lt in hp. apply Z.ltb_lt, IZR_lt in hq.
  apply Rmult_lt_0_compat; trivial. now apply Rinv_0_lt_compat.
Qed.

(* A function that vanishes on [a, b] and has a derivative at x in [a,
  b] has the derivative 0 there: an
   equation between functions on an interval may be differentiated,
     at the ends of the interval too. *)
Theorem zero_derivative (g : R -> R) (a b x : R) : a < b -> a <= x <= b ->
  (forall t, a <= t <= b -> g t = 0) -> ex_derive g x -> Derive g x = 0.
Proof.
  intros hab hx hg hd. apply Derive_correct in hd. set (l := Derive g x) in *.
  apply is_derive_Reals in hd. destruct (Req_dec l 0) as [e|ne]; trivial. exfalso.
  destruct (hd (Rabs l / 2)) as [[d hd0] H].
  { pose proof (Rabs_pos_lt l ne). lra. }
  simpl in H.
  (* A step into the interval, shorter than d. *)
  assert (S : exists h, h <> 0 /\ Rabs h < d /\ a <= x + h <= b).
  { set (s := Rmin (d / 2) ((b - a) / 2)).
    assert (s1 : 0 < s) by (apply Rmin_glb_lt; lra).
    pose proof (Rmin_l (d / 2) ((b - a) / 2)). pose proof (Rmin_r (d / 2) ((b - a) / 2)).
      fold s in H0, H1.
    destruct (Rle_dec x ((a + b) / 2)).
    - exists s. rewrite Rabs_pos_eq by lra. repeat split; lra.
    - exists (- s). rewrite Rabs_Ropp, Rabs_pos_eq by lra. repeat split; lra. }
  destruct S as [h [h0 [h1 h2]]]. specialize (H h h0 h1).
  rewrite (hg (x + h) h2), (hg x hx) in H. replace ((0 - 0) / h - l) with (- l) in H by (field;
    exact h0).
  rewrite Rabs_Ropp in H. pose proof (Rabs_pos_lt l ne). lra.
Qed.
