(* A Coons patch of four curves that close at the corners has them as its boundary. *)
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Equations.
Local Open Scope R_scope.

Definition claim : Prop := forall C1 C2 D1 D2 : R -> R,
  C1 0 = D1 0 -> C1 1 = D2 0 -> C2 0 = D1 1 -> C2 1 = D2 1 ->
  let P := fun u v => (1 - v) * C1 u + v * C2 u + ((1 - u) * D1 v + u * D2 v)
    - ((1 - u) * (1 - v) * C1 0 + (1 - u) * v * C2 0 + u * (1 - v) * C1 1 + u * v * C2 1) in
  forall u, P u 0 = C1 u.

Definition curve (j : nat) (t : term) := App (Unknown j) [t].
Definition patch : fn :=
  let u := Var 0 in let v := Var 1 in let one := Int 1 in
  Lam 2 (Sub (Add (Add (Mul (Sub one v) (curve 0 u)) (Mul v (curve 1 u)))
                  (Add (Mul (Sub one u) (curve 2 v)) (Mul u (curve 3 v))))
             (Add (Add (Add (Mul (Mul (Sub one u) (Sub one v)) (curve 0 (Int 0)))
                            (Mul (Mul (Sub one u) v) (curve 1 (Int 0))))
                       (Mul (Mul u (Sub one v)) (curve 0 (Int 1))))
                  (Mul (Mul u v) (curve 1 (Int 1))))).
Definition closed : list (term * term) :=
  [(curve 0 (Int 0), curve 2 (Int 0)); (curve 0 (Int 1), curve 3 (Int 0));
   (curve 1 (Int 0), curve 2 (Int 1)); (curve 1 (Int 1), curve 3 (Int 1))].

Theorem certified : claim.
Proof.
  intros C1 C2 D1 D2 h1 h2 h3 h4 P u.
  pose (Phi := [fun l => C1 (nth 0 l 0); fun l => C2 (nth 0 l 0);
    fun l => D1 (nth 0 l 0); fun l => D2 (nth 0 l 0)]).
  refine (equation Phi [u] [] 1 closed [] []
    [Sub (Var 0) (Int 1); Opp (Var 0); Int 0; Int 0]
    (App patch [Var 0; Int 0]) (curve 0 (Var 0)) I eq_refl (conj h1 (conj h2 (conj h3 (conj h4 I)))) I _).
  Time vm_cast_no_check (eq_refl true).
Time Qed.
Print Assumptions certified.
