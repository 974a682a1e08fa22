(* Binder-free expressions: polynomials in variables and atoms.
  Atoms are jets (derivatives of unknown
   functions at expressions), inverses and square roots. *)
Require Import QArith Qreals.
Require Import PatchProof.Definitions PatchProof.Terms.
Local Open Scope R_scope.

Inductive ex : Type :=
  | Num (q : Q)
  | At (p : positive)                                        (* a variable *)
  | Plus (a b : ex)
  | Minus (a b : ex)
  | Times (a b : ex)
  | Negate (a : ex)
  | Power (a : ex) (n : nat)
  | Jet (j : nat) (orders : list nat) (arguments : list ex)
    (* derivative of the j-th unknown function *)
  | Inverse (a : ex)
  | Root (a : ex).

(* The derivative of f of the given orders; the orders belong to the arguments from the k-th one
  on, and the
   derivatives in the earlier arguments are taken last. *)
Fixpoint jet (k : nat) (orders : list nat) (f : list R -> R) : list R -> R :=
  match orders with
  | [] => f
  | n :: l => Nat.iter n (partial k) (jet (S k) l f)
  end.

Section Evaluation.
Variable Phi : list (list R -> R).

Fixpoint eval (rho : positive -> R) (e : ex) : R :=
  match e with
  | Num q => Q2R q
  | At p => rho p
  | Plus a b => eval rho a + eval rho b
  | Minus a b => eval rho a - eval rho b
  | Times a b => eval rho a * eval rho b
  | Negate a => - eval rho a
  | Power a n => eval rho a ^ n
  | Jet j o l => jet 0 o (unknown Phi j) (map (eval rho) l)
  | Inverse a => / eval rho a
  | Root a => sqrt (eval rho a)
  end.
End Evaluation.

Section Induction.
Variable P : ex -> Prop.
Hypothesis num : forall q, P (Num q).
Hypothesis at_ : forall p, P (At p).
Hypothesis plus_ : forall a b, P a -> P b -> P (Plus a b).
Hypothesis minus_ : forall a b, P a -> P b -> P (Minus a b).
Hypothesis times_ : forall a b, P a -> P b -> P (Times a b).
Hypothesis negate_ : forall a, P a -> P (Negate a).
Hypothesis power_ : forall a n, P a -> P (Power a n).
Hypothesis jet_ : forall j o l, Forall P l -> P (Jet j o l).
Hypothesis inverse_ : forall a, P a -> P (Inverse a).
Hypothesis root_ : forall a, P a -> P (Root a).
Fixpoint ex_induction (e : ex) : P e :=
  match e with
  | Num q => num q
  | At p => at_ p
  | Plus a b => plus_ a b (ex_induction a) (ex_induction b)
  | Minus a b => minus_ a b (ex_induction a) (ex_induction b)
  | Times a b => times_ a b (ex_induction a) (ex_induction b)
  | Negate a => negate_ a (ex_induction a)
  | Power a n => power_ a n (ex_induction a)
  | Jet j o l => jet_ j o l
      ((fix go l : Forall P l := match l with
        | [] => Forall_nil P
        | a :: l' => Forall_cons a (ex_induction a) (go l') end) l)
  | Inverse a => inverse_ a (ex_induction a)
  | Root a => root_ a (ex_induction a)
  end.
End Induction.

(* An order of expressions; Eq only for equal ones. *)
Notation then_ c d := (match c with Eq => d | Lt => Lt | Gt => Gt end) (only parsing).
Definition compare_lists {A} (f : A -> A -> comparison) : list A -> list A -> comparison :=
  fix go l m :=
  match l, m with
  | [], [] => Eq
  | [], _ => Lt
  | _, [] => Gt
  | a :: l', b :: m' => then_ (f a b) (go l' m')
  end.
Definition rank (e : ex) : nat :=
  match e with
  | Num _ => 0 | At _ => 1 | Plus _ _ => 2 | Minus _ _ => 3 | Times _ _ => 4 | Negate _ => 5
  | Power _ _ => 6 | Jet _ _ _ => 7 | Inverse _ => 8 | Root _ => 9
  end.
Definition compare_rationals (p q : Q) : comparison :=
  then_ (Z.compare (Qnum p) (Qnum q)) (Pos.compare (Qden p) (Qden q)).
Fixpoint compare (a b : ex) {struct a} : comparison :=
  match a, b with
  | Num p, Num q => compare_rationals p q
  | At p, At q => Pos.compare p q
  | Plus a1 a2, Plus b1 b2 => then_ (compare a1 b1) (compare a2 b2)
  | Minus a1 a2, Minus b1 b2 => then_ (compare a1 b1) (compare a2 b2)
  | Times a1 a2, Times b1 b2 => then_ (compare a1 b1) (compare a2 b2)
  | Negate a1, Negate b1 => compare a1 b1
  | Power a1 n, Power b1 m => then_ (Nat.compare n m) (compare a1 b1)
  | Jet i o l, Jet j p m =>
      then_ (Nat.compare i j) (then_ (compare_lists Nat.compare o p) (compare_lists compare l m))
  | Inverse a1, Inverse b1 => compare a1 b1
  | Root a1, Root b1 => compare a1 b1
  | _, _ => Nat.compare (rank a) (rank b)
  end.
Definition equal (a b : ex) : bool := match compare a b with Eq => true | _ => false end.

Lemma then_eq (c d : comparison) : then_ c d = Eq -> c = Eq /\ d = Eq.
Proof. destruct c; intuition discriminate. Qed.
Lemma compare_lists_eq {A} (f : A -> A -> comparison) l :
  Forall (fun a => forall b, f a b = Eq -> a = b) l -> forall m, compare_lists f l m = Eq -> l = m.
Proof.
  induction 1 as [|a l h _ IH]; intros [|b m] e; simpl in e; try discriminate; trivial.
  apply then_eq in e. destruct e as [e1 e2]. f_equal; auto.
Qed.
Lemma compare_eq : forall a b, compare a b = Eq -> a = b.
Proof.
  induction a using ex_induction; intros [] e; simpl in e; try discriminate;
    try (apply then_eq in e; destruct e as [e1 e2]); try (f_equal; now auto).
  - destruct q as [n d], q0 as [n' d']; simpl in *. apply Z.compare_eq in e1.
      apply Pos.compare_eq in e2.
    now subst.
  - f_equal. now apply Pos.compare_eq.
  - apply Nat.compare_eq in e1. f_equal; auto.
  - apply then_eq in e2. destruct e2 as [e2 e3]. apply Nat.compare_eq in e1.
    f_equal; trivial.
    + apply (compare_lists_eq Nat.compare); trivial. rewrite Forall_forall. intros.
        now apply Nat.compare_eq.
    + now apply (compare_lists_eq compare).
Qed.
Lemma equal_eq a b : equal a b = true -> a = b.
Proof. unfold equal. destruct (compare a b) eqn:E; try discriminate. intros _.
  now apply compare_eq. Qed.

(* Does the variable x occur? *)
Fixpoint occurs (x : positive) (e : ex) : bool :=
  match e with
  | Num _ => false
  | At p => Pos.eqb p x
  | Plus a b | Minus a b | Times a b => occurs x a || occurs x b
  | Negate a | Power a _ | Inverse a | Root a => occurs x a
  | Jet _ _ l => existsb (occurs x) l
  end.
(* Another value for the variable x. *)
Definition update (rho : positive -> R) (x : positive) (t : R) (p : positive) : R :=
  if Pos.eqb p x then t else rho p.
Lemma existsb_false {A} (f : A -> bool) l : existsb f l = false -> Forall (fun a => f a = false) l.
Proof.
  induction l as [|a l IH]; simpl; intro h; constructor; apply orb_false_elim in h; destruct h;
    auto.
Qed.
Lemma Forall_and2 {A} (P Q : A -> Prop) l : Forall P l -> Forall Q l ->
  Forall (fun a => P a /\ Q a) l.
Proof. induction 1; intro h; inversion h; subst; constructor; auto. Qed.
Lemma map_eq {A B} (f g : A -> B) l : Forall (fun a => f a = g a) l -> map f l = map g l.
Proof. induction 1; simpl; congruence. Qed.
Lemma eval_update Phi rho x t e : occurs x e = false -> eval Phi (update rho x t)
  e = eval Phi rho e.
Proof.
  induction e using ex_induction; simpl; intro h; trivial;
    try (apply orb_false_elim in h; destruct h as [h1 h2]; now rewrite IHe1, IHe2);
    try (now rewrite IHe).
  - unfold update. now rewrite h.
  - f_equal. apply map_eq. apply existsb_false in h. pose proof (Forall_and2 _ _ _ H h) as h'.
    revert h'. apply Forall_impl. intros a [h1 h2]; auto.
Qed.

(* The expression with s for the variable x. *)
Fixpoint substitute (x : positive) (s : ex) (e : ex) : ex :=
  match e with
  | Num _ => e
  | At p => if Pos.eqb p x then s else e
  | Plus a b => Plus (substitute x s a) (substitute x s b)
  | Minus a b => Minus (substitute x s a) (substitute x s b)
  | Times a b => Times (substitute x s a) (substitute x s b)
  | Negate a => Negate (substitute x s a)
  | Power a n => Power (substitute x s a) n
  | Jet j o l => Jet j o (map (substitute x s) l)
  | Inverse a => Inverse (substitute x s a)
  | Root a => Root (substitute x s a)
  end.
Lemma eval_substitute Phi rho x s e :
  eval Phi rho (substitute x s e) = eval Phi (update rho x (eval Phi rho s)) e.
Proof.
  induction e using ex_induction; simpl; try congruence.
  - unfold update. now destruct (Pos.eqb p x).
  - f_equal. rewrite map_map. now apply map_eq.
Qed.
