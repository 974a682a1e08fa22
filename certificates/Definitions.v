(* The vocabulary of the statements.  A reader who wants to know what was proved reads this file
  and the
   statement of the certificate, nothing else (besides Reals of the standard library and the
     definitions
   of Derive and RInt in Coquelicot). *)
Require Export Reals List QArith_base.
From Coquelicot Require Export Rbar Hierarchy Continuity Derive RInt.
Export ListNotations.
Local Open Scope R_scope.

(* n over k, by Pascal's triangle; 0 for k > n. *)
Fixpoint binom (n k : nat) : Z :=
  match n, k with
  | _, O => 1%Z
  | O, S _ => 0%Z
  | S n', S k' => (binom n' k' + binom n' k)%Z
  end.

(* The Bernstein polynomial B_i^n(t). *)
Definition Bern (n i : nat) (t : R) : R := IZR (binom n i) * t ^ i * (1 - t) ^ (n - i).

(* Partial derivatives of functions of two and of three arguments.
  Derive f x is Coquelicot's f'(x);
   where f is not differentiable its value is not specified by anything that is used here. *)
Definition D_u (r : R -> R -> R) (u v : R) : R := Derive (fun t => r t v) u.
Definition D_v (r : R -> R -> R) (u v : R) : R := Derive (fun t => r u t) v.
Definition D_1 (r : R -> R -> R -> R) (u v w : R) : R := Derive (fun t => r t v w) u.
Definition D_2 (r : R -> R -> R -> R) (u v w : R) : R := Derive (fun t => r u t w) v.
Definition D_3 (r : R -> R -> R -> R) (u v w : R) : R := Derive (fun t => r u v t) w.

(* f is n times differentiable everywhere. *)
Definition smooth (n : nat) (f : R -> R) : Prop :=
  forall k x, (k < n)%nat -> ex_derive (Nat.iter k Derive f) x.

(* r is continuous at (u, v). *)
Definition continuous2 (r : R -> R -> R) (u v : R) : Prop :=
  forall eps, 0 < eps -> exists delta, 0 < delta /\
  forall x y, Rabs (x - u) < delta -> Rabs (y - v) < delta -> Rabs (r x y - r u v) < eps.
Definition continuous3 (r : R -> R -> R -> R) (u v w : R) : Prop :=
  forall eps, 0 < eps -> exists delta, 0 < delta /\
  forall x y z, Rabs (x - u) < delta -> Rabs (y - v) < delta -> Rabs (z - w) < delta ->
    Rabs (r x y z - r u v w) < eps.

(* All partial derivatives of r up to the order n exist everywhere and are continuous. *)
Fixpoint smooth2 (n : nat) (r : R -> R -> R) : Prop :=
  (forall u v, continuous2 r u v) /\
  match n with
  | O => True
  | S n' => (forall u v, ex_derive (fun t => r t v) u /\ ex_derive (fun t => r u t) v) /\
      smooth2 n' (D_u r) /\ smooth2 n' (D_v r)
  end.
Fixpoint smooth3 (n : nat) (r : R -> R -> R -> R) : Prop :=
  (forall u v w, continuous3 r u v w) /\
  match n with
  | O => True
  | S n' =>
      (forall u v w, ex_derive (fun t => r t v w) u /\ ex_derive (fun t => r u t w) v /\
         ex_derive (fun t => r u v t) w) /\
      smooth3 n' (D_1 r) /\ smooth3 n' (D_2 r) /\ smooth3 n' (D_3 r)
  end.

(* B-splines by the recursion of Cox and de Boor.  The knots are rational; 0/0 is 0.
  N_piece is the polynomial
   that the basis function N_{i,p} is between the knots number span and span + 1, at x,
     and Nspline the same with
   the local parameter t from 0 to 1 between these two knots. *)
Definition rational (q : Q) : R := IZR (Qnum q) / IZR (Zpos (Qden q)).
Definition knot (knots : list Q) (i : nat) : Q := nth i knots 0%Q.
Definition weight (x : R) (d : Q) : R := if Qeq_bool d 0 then 0 else x / rational d.
Fixpoint N_piece (knots : list Q) (p i span : nat) (x : R) : R :=
  match p with
  | O => if Nat.eqb i span then 1 else 0
  | S q =>
      weight (x - rational (knot knots i)) (knot knots (i + p) - knot knots i)%Q
        * N_piece knots q i span x
      + weight (rational (knot knots (i + p + 1)) - x) (knot knots (i + p + 1)
          - knot knots (i + 1))%Q
        * N_piece knots q (i + 1) span x
  end.
Definition Nspline (knots : list Q) (p i span : nat) (t : R) : R :=
  N_piece knots p i span ((1 - t) * rational (knot knots span)
    + t * rational (knot knots (span + 1))).
