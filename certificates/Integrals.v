(* Integrals of expressions that are polynomials in the variable of integration. *)
Require Import QArith Qreals Lia Lra micromega.EnvRing.
From Coquelicot Require Import RInt_analysis.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Jets PatchProof.Derivatives.
Local Open Scope R_scope.

(* An antiderivative in x of t^s times the polynomial p, whose variables are counted from place j.
  *)
Fixpoint antiderivative (T : list ex) (x : positive) (s : nat) (j : positive) (p : poly) : ex :=
  match p with
  | Pc c => Times (Num (qmul c (1 # Pos.of_succ_nat s))) (Power (At x) (S s))
  | Pinj k p => antiderivative T x s (j + k) p
  | PX p i q =>
      Plus (if Pos.eqb j (xO x) then antiderivative T x (s + Pos.to_nat i) j p
            else Times (antiderivative T x s j p) (power (variable T j) i))
           (antiderivative T x s (Pos.succ j) q)
  end.
Definition primitive (x : positive) (e : ex) : ex :=
  let T := table (atoms e) in normal (antiderivative T x 0 1 (polynomial T e)).
Definition is_zero (e : ex) : bool := match normal e with Num q => Qeq_bool q 0 | _ => false end.
Definition empty {A} (l : list A) : bool := match l with [] => true | _ => false end.
(* The integral from a to b of e with respect to x; only for e that is a polynomial in x. *)
Definition integral (S : list (nat * nat)) (x : positive) (a b e : ex) : option ex :=
  let F := primitive x e in
  if differentiable S x F && empty (denominators x F) && differentiable S x e && empty
    (denominators x e)
     && is_zero (Minus (derivative x F) e)
  then Some (normal (Minus (substitute x b F) (substitute x a F))) else None.

Section Correctness.
Variable smoothness : list (nat * nat).
Variable Phi : list (list R -> R).
Hypothesis smooth_functions : smooth_all smoothness Phi.

(* All of c are different from 0. *)
Definition nonzero (rho : positive -> R) (c : list ex) : Prop :=
  Forall (fun d => eval Phi rho d <> 0) c.

Lemma is_zero_value rho e : is_zero e = true -> eval Phi rho e = 0.
Proof.
  unfold is_zero. rewrite <- (normal_value Phi rho e). destruct (normal e); try discriminate.
  intro h. apply Qeq_bool_eq in h. simpl. rewrite (Qeq_eqR _ _ h). apply zero_value.
Qed.
Lemma update_self rho x t : update rho x t x = t.
Proof. unfold update. now rewrite Pos.eqb_refl. Qed.

(* Differentiable expressions are continuous. *)
Lemma expression_continuous rho x e t : differentiable smoothness x e = true ->
  nonzero (update rho x t) (denominators x e) -> continuous (fun t => eval Phi (update rho x t) e)
    t.
Proof.
  intros h n. apply @ex_derive_continuous. eexists. now apply (derivative_value Phi smoothness).
Qed.

Lemma integral_value rho x a b e r : integral smoothness x a b e = Some r ->
  RInt (fun t => eval Phi (update rho x t) e) (eval Phi rho a) (eval Phi rho b) = eval Phi rho r.
Proof.
  unfold integral. set (F := primitive x e).
  destruct (differentiable smoothness x F) eqn:E1; try discriminate.
  destruct (denominators x F) eqn:E2; try discriminate.
  destruct (differentiable smoothness x e) eqn:E3; try discriminate.
  destruct (denominators x e) eqn:E4; try discriminate.
  destruct (is_zero (Minus (derivative x F) e)) eqn:E5; try discriminate. simpl. intros [= <-].
  rewrite normal_value. cbn [eval]. rewrite !eval_substitute.
  apply is_RInt_unique.
  apply (is_RInt_derive (fun t => eval Phi (update rho x t) F)).
  - intros t _. eapply is_derive_equal; [apply (derivative_value Phi smoothness); trivial;
      rewrite E2; constructor|].
    pose proof (is_zero_value (update rho x t) _ E5) as z. cbn [eval] in z. lra.
  - intros t _. apply expression_continuous; trivial. rewrite E4. constructor.
Qed.

End Correctness.
