(* B-splines: a clamped cubic with a double knot is C^1 there; a piece as a Bezier curve. *)
Require Import PatchProof.Certificates.

Definition knots : list Q := [0; 0; 0; 0; 1; 1; 2; 2; 2; 2]%Q.
Definition curve (span : nat) (d0 d1 d2 d3 d4 d5 t : R) : R :=
  d0 * Nspline knots 3 0 span t + d1 * Nspline knots 3 1 span t + d2 * Nspline knots 3 2 span t
  + d3 * Nspline knots 3 3 span t + d4 * Nspline knots 3 4 span t + d5 * Nspline knots 3 5 span t.
Definition curveT (span : nat) : fn :=      (* of t, with d0 .. d5 as variables 1 .. 6 *)
  Lam 1 (Add (Add (Add (Add (Add (Mul (Var 1) (BSpline knots 3 0 span (Var 0))) (Mul (Var 2)
    (BSpline knots 3 1 span (Var 0))))
    (Mul (Var 3) (BSpline knots 3 2 span (Var 0)))) (Mul (Var 4) (BSpline knots 3 3 span (Var 0))))
    (Mul (Var 5) (BSpline knots 3 4 span (Var 0)))) (Mul (Var 6) (BSpline knots 3 5 span (Var 0)))).

Definition claim_bezier : Prop := forall d0 d1 d2 d3 d4 d5 t, curve 3 d0 d1 d2 d3 d4 d5 t =
  d0 * Bern 3 0 t + d1 * Bern 3 1 t + d2 * Bern 3 2 t + (d2 + d3) / 2 * Bern 3 3 t.
Theorem bezier : claim_bezier.
Proof.
  intros d0 d1 d2 d3 d4 d5 t.
  refine (equation [] [d0; d1; d2; d3; d4; d5; t] [] 7 [] [] [] [] (App (curveT 3) [Var 6])
    (Add (Add (Add (Mul (Var 0) (Bernstein 3 0 (Var 6))) (Mul (Var 1) (Bernstein 3 1 (Var 6))))
      (Mul (Var 2) (Bernstein 3 2 (Var 6)))) (Mul (Div (Add (Var 2) (Var 3)) (Int 2))
        (Bernstein 3 3 (Var 6))))
    I eq_refl I I _).
  Time vm_cast_no_check (eq_refl true).
Time Qed.
Definition claim_joint : Prop := forall d0 d1 d2 d3 d4 d5,
  Derive (curve 3 d0 d1 d2 d3 d4 d5) 1 = Derive (curve 5 d0 d1 d2 d3 d4 d5) 0.
Theorem joint : claim_joint.
Proof.
  intros d0 d1 d2 d3 d4 d5.
  refine (equation [] [d0; d1; d2; d3; d4; d5] [] 6 [] [] [] []
    (App (Deriv 0 (curveT 3)) [Int 1]) (App (Deriv 0 (curveT 5)) [Int 0]) I eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.
(* Not C^2. *)
Definition claim_second : Prop := forall d0 d1 d2 d3 d4 d5,
  Derive (Derive (curve 3 d0 d1 d2 d3 d4 d5)) 1 = Derive (Derive (curve 5 d0 d1 d2 d3 d4 d5)) 0.
Theorem second : ~ claim_second.
Proof.
  intro h. pose (f span := App (Lam 6 (App (Deriv 0 (Deriv 0 (curveT span)))
    [Int (if Nat.eqb span 3 then 1 else 0)]))
    [Int 0; Int 1; Int 0; Int 0; Int 0; Int 0]).
  refine (different [] [] [] 0 I eq_refl (f 3%nat) (f 5%nat) _ (h 0 1 0 0 0 0)).
  vm_cast_no_check (eq_refl true).
Qed.
