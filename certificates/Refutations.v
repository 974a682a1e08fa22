(* Certificates of refutations: the exact values at a witness differ.
  Where both sides have rational values,
   whatever the variables and the unknown functions, they are compared as rational numbers. *)
Require Import QArith Qreals.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Jets PatchProof.Values PatchProof.Vanishing
  PatchProof.Equations.
Local Open Scope R_scope.

(* The rational number that a term is. *)
Definition number (smoothness : list (nat * nat)) (n : nat) (t : term) : option Q :=
  match known_value smoothness n [] t with
  | Some e => match normal e with Num q => Some q | _ => None end
  | None => None
  end.
Definition compare_values (f : Q -> Q -> bool) (smoothness : list (nat * nat)) (n : nat)
  (l r : term) : bool :=
  match number smoothness n l, number smoothness n r with Some p, Some q => f p q | _,
    _ => false end.
Definition check_different := compare_values (fun p q => negb (Qeq_bool p q)).
Definition check_le := compare_values Qle_bool.
Definition check_less := compare_values (fun p q => negb (Qle_bool q p)).

Section Soundness.
Variable Phi : list (list R -> R).
Variable sigma : list R.
Variable smoothness : list (nat * nat).
Variable n : nat.
Hypothesis smooth_functions : smooth_all smoothness Phi.
Hypothesis length_sigma : length sigma = n.

Lemma number_value t q : number smoothness n t = Some q -> denote Phi sigma t = Q2R q.
Proof.
  unfold number. destruct (known_value smoothness n [] t) as [e|] eqn:E; try discriminate.
  rewrite (known_value_correct smoothness n [] [] Phi sigma smooth_functions length_sigma I I [] t
    e E).
  rewrite <- (normal_value Phi (assignment sigma) e). destruct (normal e); try discriminate.
    now intros [= <-].
Qed.
Lemma compare_values_correct f (P : R -> R -> Prop) l r : (forall p q, f p q = true ->
  P (Q2R p) (Q2R q)) ->
  compare_values f smoothness n l r = true -> P (denote Phi sigma l) (denote Phi sigma r).
Proof.
  unfold compare_values. intro h. destruct (number smoothness n l) as [p|] eqn:L; try discriminate.
  destruct (number smoothness n r) as [q|] eqn:E; try discriminate.
  rewrite (number_value _ _ L), (number_value _ _ E). apply h.
Qed.
Theorem different l r : check_different smoothness n l r = true ->
  denote Phi sigma l <> denote Phi sigma r.
Proof.
  apply compare_values_correct with (P := fun x y => x <> y). intros p q h e. apply eqR_Qeq in e.
  apply Qeq_bool_iff in e. now rewrite e in h.
Qed.
Theorem at_most l r : check_le smoothness n l r = true -> denote Phi sigma l <= denote Phi sigma r.
Proof.
  apply compare_values_correct with (P := Rle). intros p q h. apply Qle_Rle. now apply Qle_bool_iff.
Qed.
Theorem less l r : check_less smoothness n l r = true -> denote Phi sigma l < denote Phi sigma r.
Proof.
  apply compare_values_correct with (P := Rlt). intros p q h. apply Qlt_Rlt. apply Qnot_le_lt.
    intro e.
  apply Qle_bool_iff in e. now rewrite e in h.
Qed.
End Soundness.
Arguments different Phi sigma smoothness%nat n%nat.
Arguments at_most Phi sigma smoothness%nat n%nat.
Arguments less Phi sigma smoothness%nat n%nat.
