(* An equation between functions on an interval may be differentiated. *)
Require Import QArith.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Expressions PatchProof.Normal.
Require Import PatchProof.Jets PatchProof.Derivatives PatchProof.Integrals PatchProof.Values
  PatchProof.Equations.
Require Import PatchProof.Witnesses PatchProof.Facts.
Local Open Scope R_scope.

(* A term is differentiable in Var 0 for all values; the other n variables come after it. *)
Definition check_differentiable (smoothness : list (nat * nat)) (n : nat) (t : term) : bool :=
  match value smoothness 2 (At 1 :: variables n) t with
  | Some (e, []) => differentiable smoothness 1 (normal e) && empty (denominators 1 (normal e))
  | _ => false
  end.

Section Differentiation.
Variable Phi : list (list R -> R).
Variable sigma : list R.
Variable smoothness : list (nat * nat).
Variable n : nat.
Hypothesis smooth_functions : smooth_all smoothness Phi.
Hypothesis length_sigma : length sigma = n.

Lemma differentiable_term t x : check_differentiable smoothness n t = true ->
  ex_derive (fun s => denote Phi (s :: sigma) t) x.
Proof.
  unfold check_differentiable. destruct (value _ 2 _ t) as [[e [|? ?]]|] eqn:E; try discriminate.
  intro h. apply andb_prop in h. destruct h as [h1 h2].
  destruct (denominators 1 (normal e)) eqn:D; try discriminate.
  exists (eval Phi (update (assignment sigma) 1 x) (derivative 1 (normal e))).
  apply is_derive_ext with (fun s => eval Phi (update (assignment sigma) 1 s) (normal e)).
  - intro s. rewrite normal_value, <- (value_correct _ _ smooth_functions t _ _ _ _ _ E)
      by constructor.
    cbn [map eval]. rewrite update_self. pose proof (variables_one Phi sigma n length_sigma s) as V.
    unfold at1 in V. now rewrite V.
  - apply (derivative_value Phi smoothness); trivial. rewrite D. constructor.
Qed.
Theorem differentiated l r (a b x : R) : a < b -> a <= x <= b ->
  (forall t, a <= t <= b -> denote Phi (t :: sigma) l = denote Phi (t :: sigma) r) ->
  check_differentiable smoothness n l && check_differentiable smoothness n r = true ->
  Derive (fun t => denote Phi (t :: sigma) l) x = Derive (fun t => denote Phi (t :: sigma) r) x.
Proof.
  intros hab hx e c. apply andb_prop in c. destruct c as [c1 c2].
  apply Rminus_diag_uniq. rewrite <- Derive_minus by now apply differentiable_term.
  apply (zero_derivative _ a b); trivial.
  - intros t h. apply Rminus_diag_eq. now apply e.
  - apply @ex_derive_minus; now apply differentiable_term.
Qed.
End Differentiation.
Arguments differentiated Phi sigma smoothness%nat n%nat.
