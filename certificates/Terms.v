(* Deep terms: the twin of a statement.  The denotation computes,
  so that a concrete twin is convertible
   with the statement it stands for; the kernel compares the two, no tactic has to be trusted. *)
Require Import PatchProof.Definitions.
Local Open Scope R_scope.

Inductive term : Type :=
  | Int (z : Z)
  | Var (k : nat)                            (* the k-th variable, from 0 *)
  | Add (a b : term)
  | Sub (a b : term)
  | Mul (a b : term)
  | Opp (a : term)
  | Div (a b : term)
  | Pow (a : term) (n : nat)
  | Bernstein (n i : nat) (a : term)
  | BSpline (knots : list Q) (p i span : nat) (a : term)
  | App (f : fn) (arguments : list term)
  | Integral (lower upper body : term)       (* the body binds Var 0 *)
  | Sqrt (a : term)
with fn : Type :=
  | Lam (n : nat) (body : term)              (* binds Var 0 .. n-1, the first parameter is Var 0 *)
  | Deriv (k : nat) (f : fn)                 (* partial derivative in the k-th argument, from 0 *)
  | Unknown (j : nat).                       (* the j-th unknown function *)

(* The list with its k-th entry replaced by x. *)
Fixpoint set {A : Type} (k : nat) (x : A) (l : list A) : list A :=
  match l, k with
  | [], _ => []
  | _ :: l', O => x :: l'
  | y :: l', S k' => y :: set k' x l'
  end.

(* The partial derivative of a function of a list in the k-th entry. *)
Definition partial (k : nat) (f : list R -> R) (l : list R) : R :=
  Derive (fun t => f (set k t l)) (nth k l 0).

Definition unknown (Phi : list (list R -> R)) (j : nat) : list R -> R := nth j Phi (fun _ => 0).

(* The value of a term for unknown functions Phi and variables sigma. *)
Fixpoint denote (Phi : list (list R -> R)) (sigma : list R) (t : term) {struct t} : R :=
  match t with
  | Int z => IZR z
  | Var k => nth k sigma 0
  | Add a b => denote Phi sigma a + denote Phi sigma b
  | Sub a b => denote Phi sigma a - denote Phi sigma b
  | Mul a b => denote Phi sigma a * denote Phi sigma b
  | Opp a => - denote Phi sigma a
  | Div a b => denote Phi sigma a / denote Phi sigma b
  | Pow a n => denote Phi sigma a ^ n
  | Bernstein n i a => Bern n i (denote Phi sigma a)
  | BSpline knots p i span a => Nspline knots p i span (denote Phi sigma a)
  | App f arguments => denoteF Phi sigma f (map (denote Phi sigma) arguments)
  | Integral a b e => RInt (fun t => denote Phi (t :: sigma) e) (denote Phi sigma a)
    (denote Phi sigma b)
  | Sqrt a => sqrt (denote Phi sigma a)
  end
with denoteF (Phi : list (list R -> R)) (sigma : list R) (f : fn) {struct f} : list R -> R :=
  match f with
  | Lam _ body => fun l => denote Phi (l ++ sigma) body
  | Deriv k g => fun l => Derive (fun t => denoteF Phi sigma g (set k t l)) (nth k l 0)
  | Unknown j => unknown Phi j
  end.

(* Induction over terms and functions together, through the lists of arguments. *)
Section Induction.
Variable P : term -> Prop.
Variable Q : fn -> Prop.
Hypothesis int : forall z, P (Int z).
Hypothesis var : forall k, P (Var k).
Hypothesis add : forall a b, P a -> P b -> P (Add a b).
Hypothesis sub : forall a b, P a -> P b -> P (Sub a b).
Hypothesis mul : forall a b, P a -> P b -> P (Mul a b).
Hypothesis opp : forall a, P a -> P (Opp a).
Hypothesis div : forall a b, P a -> P b -> P (Div a b).
Hypothesis power : forall a n, P a -> P (Pow a n).
Hypothesis bernstein : forall n i a, P a -> P (Bernstein n i a).
Hypothesis bspline : forall l p i s a, P a -> P (BSpline l p i s a).
Hypothesis app : forall f l, Q f -> Forall P l -> P (App f l).
Hypothesis integral : forall a b e, P a -> P b -> P e -> P (Integral a b e).
Hypothesis root : forall a, P a -> P (Sqrt a).
Hypothesis lam : forall n e, P e -> Q (Lam n e).
Hypothesis deriv : forall k f, Q f -> Q (Deriv k f).
Hypothesis unknown_case : forall j, Q (Unknown j).

Fixpoint term_induction (t : term) : P t :=
  match t with
  | Int z => int z
  | Var k => var k
  | Add a b => add a b (term_induction a) (term_induction b)
  | Sub a b => sub a b (term_induction a) (term_induction b)
  | Mul a b => mul a b (term_induction a) (term_induction b)
  | Opp a => opp a (term_induction a)
  | Div a b => div a b (term_induction a) (term_induction b)
  | Pow a n => power a n (term_induction a)
  | Bernstein n i a => bernstein n i a (term_induction a)
  | BSpline l p i s a => bspline l p i s a (term_induction a)
  | App f l => app f l (fn_induction f)
      ((fix go l : Forall P l := match l with
        | [] => Forall_nil P
        | a :: l' => Forall_cons a (term_induction a) (go l') end) l)
  | Integral a b e => integral a b e (term_induction a) (term_induction b) (term_induction e)
  | Sqrt a => root a (term_induction a)
  end
with fn_induction (f : fn) : Q f :=
  match f with
  | Lam n e => lam n e (term_induction e)
  | Deriv k g => deriv k g (fn_induction g)
  | Unknown j => unknown_case j
  end.
End Induction.
