(* Curves: degree elevation, a rational curve, a bound, an integral and a minimum. *)
Require Import PatchProof.Certificates.

Definition claim_elevation : Prop := forall b0 b1 b2 b3 t : R,
  b0 * Bern 3 0 t + b1 * Bern 3 1 t + b2 * Bern 3 2 t + b3 * Bern 3 3 t =
  b0 * Bern 4 0 t + (1 / 4 * b0 + 3 / 4 * b1) * Bern 4 1 t + (b1 + b2) / 2 * Bern 4 2 t
  + (3 / 4 * b2 + 1 / 4 * b3) * Bern 4 3 t + b3 * Bern 4 4 t.
Theorem elevation : claim_elevation.
Proof.
  intros b0 b1 b2 b3 t.
  refine (equation [] [t; b0; b1; b2; b3] [] 5 [] [] [] []
    (Add (Add (Add (Mul (Var 1) (Bernstein 3 0 (Var 0))) (Mul (Var 2) (Bernstein 3 1 (Var 0))))
              (Mul (Var 3) (Bernstein 3 2 (Var 0)))) (Mul (Var 4) (Bernstein 3 3 (Var 0))))
    (Add (Add (Add (Add (Mul (Var 1) (Bernstein 4 0 (Var 0)))
      (Mul (Add (Mul (Div (Int 1) (Int 4)) (Var 1)) (Mul (Div (Int 3) (Int 4)) (Var 2)))
        (Bernstein 4 1 (Var 0))))
      (Mul (Div (Add (Var 2) (Var 3)) (Int 2)) (Bernstein 4 2 (Var 0))))
      (Mul (Add (Mul (Div (Int 3) (Int 4)) (Var 3)) (Mul (Div (Int 1) (Int 4)) (Var 4)))
        (Bernstein 4 3 (Var 0))))
      (Mul (Var 4) (Bernstein 4 4 (Var 0))))
    I eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.

(* A quarter circle as a rational curve; the weight of the middle point is a root of 1/2. *)
Definition W (t : R) : R := Bern 2 0 t + sqrt (1 / 2) * Bern 2 1 t + Bern 2 2 t.
Definition X (t : R) : R := (Bern 2 0 t + sqrt (1 / 2) * Bern 2 1 t) / W t.
Definition Y (t : R) : R := (sqrt (1 / 2) * Bern 2 1 t + Bern 2 2 t) / W t.
Definition claim_circle : Prop := forall t, W t <> 0 -> X t ^ 2 + Y t ^ 2 = 1.
Definition root := Sqrt (Div (Int 1) (Int 2)).
Definition WT : fn := Lam 1 (Add (Add (Bernstein 2 0 (Var 0)) (Mul root (Bernstein 2 1 (Var 0))))
  (Bernstein 2 2 (Var 0))).
Definition XT : fn := Lam 1 (Div (Add (Bernstein 2 0 (Var 0)) (Mul root (Bernstein 2 1 (Var 0))))
  (App WT [Var 0])).
Definition YT : fn := Lam 1 (Div (Add (Mul root (Bernstein 2 1 (Var 0))) (Bernstein 2 2 (Var 0)))
  (App WT [Var 0])).
Theorem circle : claim_circle.
Proof.
  intros t w.
  refine (equation [] [t] [] 1 [(Mul root root, Div (Int 1) (Int 2))] [App WT [Var 0]] []
    [Div (Mul (Int 4) (Mul (Pow (Var 0) 2) (Pow (Sub (Int 1) (Var 0)) 2))) (Pow (App WT [Var 0]) 2)]
    (Add (Pow (App XT [Var 0]) 2) (Pow (App YT [Var 0]) 2)) (Int 1) I eq_refl
    (conj (root_square_quotient 1 2 eq_refl eq_refl) I) (conj w I) _).
  vm_cast_no_check (eq_refl true).
Qed.

(* A bound with a split at the middle. *)
Definition claim_bound : Prop := forall t, 0 <= t -> t <= 1 -> t * (1 - t) <= 1 / 4.
Theorem bound : claim_bound.
Proof.
  intros t h0 h1. apply le_from_difference.
  refine (nonnegative [] [t] [] 1 [] [] [] [(Var 0, false); (Sub (Int 1) (Var 0), false)]
    (Sub (Div (Int 1) (Int 4)) (Mul (Var 0) (Sub (Int 1) (Var 0))))
    (Split (Sub (Div (Int 1) (Int 2)) (Var 0))
       (Done (Sum [Summand 1 [] [Factor 2 2]] []))
       (Done (Sum [Summand 1 [] [Factor 2 2]] [])))
    I eq_refl I I (conj h0 (conj (le_difference _ _ h1) I)) _).
  vm_cast_no_check (eq_refl true).
Qed.
(* A strict bound, with an intermediate fact. *)
Definition claim_strict : Prop := forall t, 0 < t -> t <= 1 -> 0 < t ^ 3 + 2 * (1 - t) * t.
Theorem strict : claim_strict.
Proof.
  intros t h0 h1.
  refine (positive [] [t] [] 1 [] [] [] [(Var 0, true); (Sub (Int 1) (Var 0), false)]
    (Add (Pow (Var 0) 3) (Mul (Mul (Int 2) (Sub (Int 1) (Var 0))) (Var 0)))
    (Step (Pow (Var 0) 3) true (Sum [Summand 1 [] [Factor 0 3]] [])
      (Done (Sum [Summand 1 [] [Factor 2 1]; Summand 2 [] [Factor 0 1; Factor 1 1]] [])))
    I eq_refl I I (conj h0 (conj (le_difference _ _ h1) I)) _).
  vm_cast_no_check (eq_refl true).
Qed.

(* An integral with symbolic bounds. *)
Definition claim_integral : Prop := forall a b : R, RInt (fun t => t * (b - t)) a b = (b - a)
  ^ 2 * (b + 2 * a) / 6.
Theorem integral : claim_integral.
Proof.
  intros a b.
  refine (equation [] [a; b] [] 2 [] [] [] []
    (Integral (Var 0) (Var 1) (Mul (Var 0) (Sub (Var 2) (Var 0))))
    (Div (Mul (Pow (Sub (Var 1) (Var 0)) 2) (Add (Var 1) (Mul (Int 2) (Var 0)))) (Int 6))
      I eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.

(* Among the parabolas from b0 to b2 the segment has the least energy. *)
Definition energy (f : R -> R) : R := RInt (fun t => Derive f t ^ 2) 0 1.
Definition claim_minimum : Prop := forall b0 b1 b2 : R,
  energy (fun t => b0 * Bern 2 0 t + (b0 + b2) / 2 * Bern 2 1 t + b2 * Bern 2 2 t)
  <= energy (fun t => b0 * Bern 2 0 t + b1 * Bern 2 1 t + b2 * Bern 2 2 t).
Definition parabola (b0 b1 b2 : term) : fn :=
  Lam 1 (Add (Add (Mul b0 (Bernstein 2 0 (Var 0))) (Mul b1 (Bernstein 2 1 (Var 0))))
    (Mul b2 (Bernstein 2 2 (Var 0)))).
Definition energyT (f : fn) : term := Integral (Int 0) (Int 1) (Pow (App (Deriv 0 f) [Var 0]) 2).
Theorem minimum : claim_minimum.
Proof.
  intros b0 b1 b2. apply le_from_difference.
  refine (nonnegative [] [b0; b1; b2] [] 3 [] [] [] []
    (* Inside the integral and the function the points are two places further. *)
    (Sub (energyT (parabola (Var 2) (Var 3) (Var 4)))
         (energyT (parabola (Var 2) (Div (Add (Var 2) (Var 4)) (Int 2)) (Var 4))))
    (Done (Sum [Summand (4 # 3) [Sub (Var 1) (Div (Add (Var 0) (Var 2)) (Int 2))] []] []))
    I eq_refl I I I _).
  vm_cast_no_check (eq_refl true).
Qed.
Print Assumptions minimum.
