(* Derivatives: of quotients, of unknown functions of several arguments, of sine and cosine;
  a refutation. *)
Require Import PatchProof.Certificates.

(* The derivative of a quotient, where the denominator is not 0. *)
Definition claim_quotient : Prop := forall f w : R -> R, smooth 1 f -> smooth 1 w ->
  forall t, w t <> 0 ->
  Derive (fun s => f s / w s) t = (Derive f t * w t - f t * Derive w t) / w t ^ 2.
Theorem quotient : claim_quotient.
Proof.
  intros f w sf sw t z.
  refine (equation [fun l => f (nth 0 l 0); fun l => w (nth 0 l 0)] [t] [Smooth 1 1; Smooth 1 1] 1
    [] [App (Unknown 1) [Var 0]] [] []
    (App (Deriv 0 (Lam 1 (Div (App (Unknown 0) [Var 0]) (App (Unknown 1) [Var 0])))) [Var 0])
    (Div (Sub (Mul (App (Deriv 0 (Unknown 0)) [Var 0]) (App (Unknown 1) [Var 0]))
              (Mul (App (Unknown 0) [Var 0]) (App (Deriv 0 (Unknown 1)) [Var 0])))
                (Pow (App (Unknown 1) [Var 0]) 2))
    (conj sf (conj sw I)) eq_refl I (conj z I) _).
  vm_cast_no_check (eq_refl true).
Qed.
(* Twice: the second derivative of 1/t is 2/t^3. *)
Definition claim_inverse : Prop := forall t, t <> 0 -> Derive (Derive (fun s => 1 / s))
  t = 2 / t ^ 3.
Theorem inverse : claim_inverse.
Proof.
  intros t z.
  refine (equation [] [t] [] 1 [] [Var 0] [] []
    (App (Deriv 0 (Deriv 0 (Lam 1 (Div (Int 1) (Var 0))))) [Var 0]) (Div (Int 2) (Pow (Var 0) 3))
      I eq_refl I (conj z I) _).
  vm_cast_no_check (eq_refl true).
Qed.
(* The two mixed derivatives of a patch, and the chain rule along its diagonal. *)
Definition claim_mixed : Prop := forall r, smooth2 3 r -> forall u v,
  D_u (D_v (D_u r)) u v = D_v (D_u (D_u r)) u v.
Definition claim_diagonal : Prop := forall r, smooth2 2 r -> forall t,
  Derive (Derive (fun s => r s (s ^ 2))) t
  = D_u (D_u r) t (t ^ 2) + 4 * t * D_v (D_u r) t (t ^ 2) + 4 * t ^ 2 * D_v (D_v r) t (t ^ 2)
    + 2 * D_v r t (t ^ 2).
Theorem mixed : claim_mixed.
Proof.
  intros r s u v.
  refine (equation [fun l => r (nth 0 l 0) (nth 1 l 0)] [u; v] [Smooth 2 3] 2 [] [] [] []
    (App (Deriv 0 (Deriv 1 (Deriv 0 (Unknown 0)))) [Var 0; Var 1])
    (App (Deriv 1 (Deriv 0 (Deriv 0 (Unknown 0)))) [Var 0; Var 1]) (conj s I) eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.
Theorem diagonal : claim_diagonal.
Proof.
  intros r s t.
  pose (at_ f := App f [Var 0; Pow (Var 0) 2]). pose (r_ := Unknown 0).
  refine (equation [fun l => r (nth 0 l 0) (nth 1 l 0)] [t] [Smooth 2 2] 1 [] [] [] []
    (App (Deriv 0 (Deriv 0 (Lam 1 (at_ r_)))) [Var 0])
    (Add (Add (Add (at_ (Deriv 0 (Deriv 0 r_))) (Mul (Mul (Int 4) (Var 0))
      (at_ (Deriv 1 (Deriv 0 r_)))))
      (Mul (Mul (Int 4) (Pow (Var 0) 2)) (at_ (Deriv 1 (Deriv 1 r_))))) (Mul (Int 2)
        (at_ (Deriv 1 r_))))
    (conj s I) eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.
Definition claim_volume : Prop := forall r, smooth3 3 r -> forall u v w,
  D_3 (D_2 (D_1 r)) u v w = D_1 (D_3 (D_2 r)) u v w.
Theorem volume : claim_volume.
Proof.
  intros r s u v w.
  refine (equation [fun l => r (nth 0 l 0) (nth 1 l 0) (nth 2 l 0)] [u; v;
    w] [Smooth 3 3] 3 [] [] [] []
    (App (Deriv 2 (Deriv 1 (Deriv 0 (Unknown 0)))) [Var 0; Var 1; Var 2])
    (App (Deriv 0 (Deriv 2 (Deriv 1 (Unknown 0)))) [Var 0; Var 1; Var 2]) (conj s I) eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.
(* The helix (cos t, sin t, t) has speed sqrt 2: its square is 2. *)
Definition claim_helix : Prop := forall t,
  Derive (fun s => cos s) t ^ 2 + Derive (fun s => sin s) t ^ 2 + Derive (fun s => s) t ^ 2 = 2.
Theorem helix : claim_helix.
Proof.
  intro t. pose (sine := Unknown 0). pose (cosine := Unknown 1).
  refine (equation [fun l => sin (nth 0 l 0); fun l => cos (nth 0 l 0)] [t] [Smooth 1 1;
    Smooth 1 1] 1
    [(App (Deriv 0 sine) [Var 0], App cosine [Var 0]); (App (Deriv 0 cosine) [Var 0],
      Opp (App sine [Var 0]));
     (Add (Mul (App sine [Var 0]) (App sine [Var 0])) (Mul (App cosine [Var 0])
       (App cosine [Var 0])), Int 1)] [] []
    [Add (App (Deriv 0 sine) [Var 0]) (App cosine [Var 0]);
      Sub (App (Deriv 0 cosine) [Var 0]) (App sine [Var 0]); Int 1]
    (Add (Add (Pow (App (Deriv 0 (Lam 1 (App cosine [Var 0]))) [Var 0]) 2)
      (Pow (App (Deriv 0 (Lam 1 (App sine [Var 0]))) [Var 0]) 2))
        (Pow (App (Deriv 0 (Lam 1 (Var 0))) [Var 0]) 2))
    (Int 2) (conj (sine_smooth 1) (conj (cosine_smooth 1) I)) eq_refl
    (conj (sine_derivative t) (conj (cosine_derivative t) (conj (sine_cosine t) I))) I _).
  vm_cast_no_check (eq_refl true).
Qed.
(* A false statement about smooth functions; the witness is r = u v at (1, 2). *)
Definition claim_false : Prop := forall r, smooth2 2 r -> forall u v, 0 <= u -> D_u (D_v r) u v = 0.
Theorem refuted : ~ claim_false.
Proof.
  intro h.
  assert (smooth_r : smooth2 2 (fun u v => u * v)).
  { refine (polynomial_smooth2 [] [] 0 eq_refl 2 (Mul (Var 0) (Var 1)) _).
    vm_cast_no_check (eq_refl true). }
  assert (order : 0 <= 1) by (refine (at_most [] [] [] 0 I eq_refl (Int 0) (Int 1) _);
    vm_cast_no_check (eq_refl true)).
  refine (different [] [] [] 0 I eq_refl
    (App (Deriv 0 (Deriv 1 (Lam 2 (Mul (Var 0) (Var 1))))) [Int 1; Int 2]) (Int 0) _
    (h (fun u v => u * v) smooth_r 1 2 order)).
  vm_cast_no_check (eq_refl true).
Qed.
(* An identity on [0, 1] may be differentiated. *)
Definition claim_tangent : Prop := forall f g : R -> R, smooth 1 f -> smooth 1 g ->
  (forall t, 0 <= t <= 1 -> f t = g t) -> Derive f 1 = Derive g 1.
Theorem tangent : claim_tangent.
Proof.
  intros f g sf sg e.
  refine (differentiated [fun l => f (nth 0 l 0); fun l => g (nth 0 l 0)] [] [Smooth 1 1;
    Smooth 1 1] 0
    (conj sf (conj sg I)) eq_refl (App (Unknown 0) [Var 0]) (App (Unknown 1) [Var 0]) 0 1 1 Rlt_0_1
    (conj Rle_0_1 (Rle_refl 1)) e _).
  vm_cast_no_check (eq_refl true).
Qed.
Print Assumptions diagonal.
