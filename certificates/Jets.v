(* Derivatives of unknown functions: the chain rule for jets. *)
Require Import Lia.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Expressions.
Local Open Scope R_scope.

(* What is assumed of an unknown function: its number of arguments and how often it may be differentiated.
   Nothing is assumed of functions of another number of arguments. *)
Definition Smooth (arguments times : nat) : nat * nat := (arguments, times).
Definition smooth_at (s : nat * nat) (f : list R -> R) : Prop :=
  match s with
  | (1, n) => smooth n (fun t => f [t])
  | _ => True
  end%nat.
Fixpoint smooth_all (S : list (nat * nat)) (Phi : list (list R -> R)) : Prop :=
  match S, Phi with
  | [], _ => True
  | s :: S', f :: Phi' => smooth_at s f /\ smooth_all S' Phi'
  | _ :: _, [] => False
  end.
Lemma smooth_all_at S : forall Phi j, smooth_all S Phi -> smooth_at (nth j S (0, 0)%nat) (unknown Phi j).
Proof.
  unfold unknown. induction S as [|s S IH]; intros [|f Phi] j h; simpl in h; destruct j; simpl; trivial; try easy.
  now apply IH.
Qed.

(* May the derivative of these orders be differentiated once more? *)
Definition differentiable_jet (s : nat * nat) (orders : list nat) : bool :=
  match s, orders with
  | (1, n), [o] => Nat.ltb o n
  | _, _ => false
  end%nat.
(* The orders with one more derivative in the k-th argument. *)
Definition bump (k : nat) (orders : list nat) : list nat := set k (S (nth k orders 0%nat)) orders.

(* The sum over the arguments of the derivative in that argument times the derivative of the argument. *)
Fixpoint chain (f : list R -> R) (orders : list nat) (values : list R) (k : nat) (slopes : list R) : R :=
  match slopes with
  | [] => 0
  | d :: l => jet 0 (bump k orders) f values * d + chain f orders values (S k) l
  end.

Lemma jet_of_one f n : forall y, jet 0 [n] f [y] = Nat.iter n Derive (fun t => f [t]) y.
Proof.
  induction n as [|n IH]; intro y; [reflexivity|].
  change (Derive (fun t => jet 0 [n] f [t]) y = Derive (Nat.iter n Derive (fun t => f [t])) y).
  now apply Derive_ext.
Qed.

Theorem jet_chain s f orders (A : list (R -> R)) (slopes : list R) x :
  smooth_at s f -> differentiable_jet s orders = true -> length A = length orders ->
  Forall2 (fun a d => is_derive a x d) A slopes ->
  is_derive (fun t => jet 0 orders f (map (fun a => a t) A)) x
    (chain f orders (map (fun a => a x) A) 0 slopes).
Proof.
  destruct s as [[|[|m]] n]; try discriminate.
  destruct orders as [|o [|? ?]]; try discriminate. simpl differentiable_jet.
  intros h hn. apply Nat.ltb_lt in hn.
  destruct A as [|a [|? ?]]; try discriminate. intros _ ha. inversion ha as [|? d ? ? ha' hb]; subst. inversion hb; subst.
  cbn [map chain bump set nth].
  apply is_derive_ext with (fun t => Nat.iter o Derive (fun t => f [t]) (a t)).
  - intro t. now rewrite jet_of_one.
  - rewrite jet_of_one, Rplus_0_r, Rmult_comm.
    apply (is_derive_comp (Nat.iter o Derive (fun t => f [t])) a x); trivial.
    apply Derive_correct, h, hn.
Qed.
