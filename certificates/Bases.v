(* Bernstein polynomials and B-splines as expressions. *)
Require Import QArith Qreals Lia.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal.
Local Open Scope R_scope.

(* Rows of Pascal's triangle; the recursion of binom itself takes exponential time. *)
Fixpoint next_row (p : Z) (l : list Z) : list Z :=
  match l with [] => [p] | x :: l' => (p + x)%Z :: next_row x l' end.
Fixpoint row (n : nat) : list Z := match n with O => [1%Z] | S n' => next_row 0 (row n') end.
Definition bernstein (n i : nat) (t : ex) : ex :=
  Times (Times (Num (inject_Z (nth i (row n) 0%Z))) (Power t i)) (Power (Minus (Num 1) t) (n - i)).

(* A piece of a B-spline basis function at x. *)
Definition over (x : ex) (d : Q) : ex := if Qeq_bool d 0 then Num 0 else Times x (Num (/ d)).
Fixpoint piece (knots : list Q) (p i span : nat) (x : ex) : ex :=
  match p with
  | O => if Nat.eqb i span then Num 1 else Num 0
  | S q =>
      Plus (Times (over (Minus x (Num (knot knots i))) (knot knots (i + p) - knot knots i)%Q)
        (piece knots q i span x))
           (Times (over (Minus (Num (knot knots (i + p + 1))) x) (knot knots (i + p + 1)
             - knot knots (i + 1))%Q)
              (piece knots q (i + 1) span x))
  end.
Definition spline (knots : list Q) (p i span : nat) (t : ex) : ex :=
  piece knots p i span (Plus (Times (Minus (Num 1) t) (Num (knot knots span)))
    (Times t (Num (knot knots (span + 1))))).

Section Values.
Variable Phi : list (list R -> R).

Lemma next_row_nth l : forall p k, nth k (next_row p l) 0%Z
  = ((match k with O => p | S k' => nth k' l 0%Z end) + nth k l 0%Z)%Z.
Proof.
  induction l as [|x l IH]; intros p [|k]; cbn [next_row nth].
  - lia.
  - destruct k; reflexivity.
  - reflexivity.
  - rewrite IH. destruct k; reflexivity.
Qed.
Lemma row_nth n : forall k, nth k (row n) 0%Z = binom n k.
Proof.
  induction n as [|n IH]; intros k.
  - destruct k as [|[|k]]; reflexivity.
  - simpl row. rewrite next_row_nth. destruct k as [|k]; rewrite !IH; [destruct n;
      reflexivity|reflexivity].
Qed.
Lemma integer_value rho z : eval Phi rho (Num (inject_Z z)) = IZR z.
Proof. simpl. unfold Q2R, inject_Z; simpl. field. Qed.
Lemma bernstein_value rho n i t : eval Phi rho (bernstein n i t) = Bern n i (eval Phi rho t).
Proof.
  unfold bernstein, Bern. rewrite row_nth. cbn [eval]. rewrite <- (integer_value rho (binom n i)).
    cbn [eval].
  now rewrite one_value.
Qed.
Lemma rational_value rho q : eval Phi rho (Num q) = rational q.
Proof. reflexivity. Qed.
Lemma over_value rho x d : eval Phi rho (over x d) = weight (eval Phi rho x) d.
Proof.
  unfold over, weight. destruct (Qeq_bool d 0) eqn:E; [exact zero_value|]. cbn [eval].
  rewrite Q2R_inv by now apply Qeq_bool_neq. reflexivity.
Qed.
Lemma piece_value rho knots p span x : forall i,
  eval Phi rho (piece knots p i span x) = N_piece knots p i span (eval Phi rho x).
Proof.
  induction p as [|p IH]; intro i; cbn [piece N_piece].
  - destruct (Nat.eqb i span); [exact one_value|exact zero_value].
  - cbn [eval]. rewrite !over_value, !IH. reflexivity.
Qed.
Lemma spline_value rho knots p i span t :
  eval Phi rho (spline knots p i span t) = Nspline knots p i span (eval Phi rho t).
Proof. unfold spline, Nspline. rewrite piece_value. cbn [eval]. rewrite one_value. reflexivity. Qed.
End Values.
