(* Coons patches of four unknown curves. *)
Require Import PatchProof.Certificates.

Definition coons (C1 C2 D1 D2 : R -> R) (u v : R) : R :=
  (1 - v) * C1 u + v * C2 u + ((1 - u) * D1 v + u * D2 v)
  - ((1 - u) * (1 - v) * C1 0 + (1 - u) * v * C2 0 + u * (1 - v) * C1 1 + u * v * C2 1).

Definition claim_boundary : Prop := forall C1 C2 D1 D2 : R -> R,
  C1 0 = D1 0 -> C1 1 = D2 0 -> C2 0 = D1 1 -> C2 1 = D2 1 ->
  forall u, coons C1 C2 D1 D2 u 0 = C1 u.
Definition claim_fourth_derivative : Prop := forall C1 C2 D1 D2 : R -> R,
  smooth 2 C1 -> smooth 2 C2 -> smooth 2 D1 -> smooth 2 D2 ->
  forall u v, D_u (D_u (D_v (D_v (coons C1 C2 D1 D2)))) u v = 0.
Definition claim_without_closure : Prop := forall C1 C2 D1 D2 : R ->
  R, forall u, coons C1 C2 D1 D2 u 0 = C1 u.

(* The twin, for any four functions. *)
Definition patch (C1 C2 D1 D2 : fn) : fn :=
  let u := Var 0 in let v := Var 1 in let one := Int 1 in let zero := Int 0 in
  let at_ f t := App f [t] in
  Lam 2 (Sub (Add (Add (Mul (Sub one v) (at_ C1 u)) (Mul v (at_ C2 u)))
                  (Add (Mul (Sub one u) (at_ D1 v)) (Mul u (at_ D2 v))))
             (Add (Add (Add (Mul (Mul (Sub one u) (Sub one v)) (at_ C1 zero))
                            (Mul (Mul (Sub one u) v) (at_ C2 zero)))
                       (Mul (Mul u (Sub one v)) (at_ C1 one)))
                  (Mul (Mul u v) (at_ C2 one)))).
Definition P : fn := patch (Unknown 0) (Unknown 1) (Unknown 2) (Unknown 3).
Definition curve (j : nat) (t : term) := App (Unknown j) [t].
Definition functions (C1 C2 D1 D2 : R -> R) : list (list R -> R) :=
  [fun l => C1 (nth 0 l 0); fun l => C2 (nth 0 l 0); fun l => D1 (nth 0 l 0);
    fun l => D2 (nth 0 l 0)].
Definition closed : list (term * term) :=
  [(curve 0 (Int 0), curve 2 (Int 0)); (curve 0 (Int 1), curve 3 (Int 0));
   (curve 1 (Int 0), curve 2 (Int 1)); (curve 1 (Int 1), curve 3 (Int 1))].

Theorem boundary : claim_boundary.
Proof.
  intros C1 C2 D1 D2 h1 h2 h3 h4 u.
  refine (equation (functions C1 C2 D1 D2) [u] [] 1 closed [] []
    [Sub (Var 0) (Int 1); Opp (Var 0); Int 0; Int 0]
    (App P [Var 0; Int 0]) (curve 0 (Var 0)) I eq_refl (conj h1 (conj h2 (conj h3 (conj h4 I))))
      I _).
  vm_cast_no_check (eq_refl true).
Qed.
Theorem fourth_derivative : claim_fourth_derivative.
Proof.
  intros C1 C2 D1 D2 s1 s2 s3 s4 u v.
  refine (equation (functions C1 C2 D1 D2) [u; v] [Smooth 1 2; Smooth 1 2; Smooth 1 2;
    Smooth 1 2] 2 [] [] [] []
    (App (Deriv 0 (Deriv 0 (Deriv 1 (Deriv 1 P)))) [Var 0; Var 1]) (Int 0)
    (conj s1 (conj s2 (conj s3 (conj s4 I)))) eq_refl I I _).
  vm_cast_no_check (eq_refl true).
Qed.
(* Witness: C1 = 1, the others 0, u = 1/2. *)
Theorem without_closure : ~ claim_without_closure.
Proof.
  intro h. refine (different [] [] [] 0 I eq_refl
    (App (patch (Lam 1 (Int 1)) (Lam 1 (Int 0)) (Lam 1 (Int 0)) (Lam 1 (Int 0))) [Div (Int 1)
      (Int 2); Int 0])
    (App (Lam 1 (Int 1)) [Div (Int 1) (Int 2)]) _ (h (fun _ => 1) (fun _ => 0) (fun _ => 0)
      (fun _ => 0) (1 / 2))).
  vm_cast_no_check (eq_refl true).
Qed.
