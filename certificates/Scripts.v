(* Small steps of the proof scripts. *)
Require Import Lra.
Require Import PatchProof.Definitions.
Local Open Scope R_scope.

Lemma gt_from_difference (a b : R) : 0 < a - b -> a > b.
Proof. lra. Qed.
Lemma ge_from_difference (a b : R) : 0 <= a - b -> a >= b.
Proof. lra. Qed.
Lemma different_of_greater (a b : R) : 0 < a - b -> a <> b.
Proof. lra. Qed.
Lemma different_of_less (a b : R) : 0 < b - a -> a <> b.
Proof. lra. Qed.
Lemma nonzero_of_positive (a : R) : 0 < a -> a <> 0.
Proof. lra. Qed.
Lemma nonzero_of_negative (a : R) : 0 < - a -> a <> 0.
Proof. lra. Qed.

(* Comparisons that fail at a witness. *)
Lemma not_less (a b : R) : b <= a -> a < b -> False.
Proof. lra. Qed.
Lemma not_at_most (a b : R) : b < a -> a <= b -> False.
Proof. lra. Qed.
Lemma not_greater (a b : R) : a <= b -> a > b -> False.
Proof. lra. Qed.
Lemma not_at_least (a b : R) : a < b -> a >= b -> False.
Proof. lra. Qed.
Lemma both_ends (a b c : R) : a <= b -> b <= c -> a <= b <= c.
Proof. split; trivial. Qed.

(* A place lies in the range of a parameter. *)
Ltac in_range := cbn beta; split; lra.

(* The first premise of H is to be shown; afterwards it is taken away from H. *)
Ltac premise H :=
  match type of H with ?P -> _ => let p := fresh in assert (p : P); [|specialize (H p); clear p] end.
