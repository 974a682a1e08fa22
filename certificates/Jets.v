(* Derivatives of unknown functions: the chain rule for jets. *)
Require Import Lia.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Expressions PatchProof.Smoothness.
Local Open Scope R_scope.

(* What is assumed of an unknown function: its number of arguments and how often it may be
  differentiated.
   Nothing is assumed of functions of another number of arguments. *)
Definition Smooth (arguments times : nat) : nat * nat := (arguments, times).
Definition smooth_at (s : nat * nat) (f : list R -> R) : Prop :=
  match s with
  | (1, n) => smooth n (fun t => f [t])
  | (2, n) => smooth2 n (fun u v => f [u; v])
  | (3, n) => smooth3 n (fun u v w => f [u; v; w])
  | _ => True
  end%nat.
Fixpoint smooth_all (S : list (nat * nat)) (Phi : list (list R -> R)) : Prop :=
  match S, Phi with
  | [], _ => True
  | s :: S', f :: Phi' => smooth_at s f /\ smooth_all S' Phi'
  | _ :: _, [] => False
  end.
Lemma smooth_all_at S : forall Phi j, smooth_all S Phi -> smooth_at (nth j S (0,
  0)%nat) (unknown Phi j).
Proof.
  unfold unknown. induction S as [|s S IH]; intros [|f Phi] j h; simpl in h; destruct j; simpl;
    trivial; try easy.
  now apply IH.
Qed.

(* May the derivative of these orders be differentiated once more? *)
Definition differentiable_jet (s : nat * nat) (orders : list nat) : bool :=
  match s, orders with
  | (1, n), [o] => Nat.ltb o n
  | (2, n), [o; p] => Nat.ltb (o + p) n
  | (3, n), [o; p; q] => Nat.ltb (o + (p + q)) n
  | _, _ => false
  end%nat.
(* The orders with one more derivative in the k-th argument. *)
Definition bump (k : nat) (orders : list nat) : list nat := set k (S (nth k orders 0%nat)) orders.

(* The sum over the arguments of the derivative in that argument times the derivative of the
  argument. *)
Fixpoint chain (f : list R -> R) (orders : list nat) (values : list R) (k : nat) (slopes : list R)
  : R :=
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

(* The derivatives of a function of a list are those of the function of its entries. *)
Lemma iter_two k (A : (list R -> R) -> list R -> R) (B : (R -> R -> R) -> R -> R -> R) :
  (forall g h, (forall u v, g [u; v] = h u v) -> forall u v, A g [u; v] = B h u v) ->
  forall g h, (forall u v, g [u; v] = h u v) -> forall u v, Nat.iter k A g [u;
    v] = Nat.iter k B h u v.
Proof. intro hAB. induction k as [|k IH]; intros g h e; trivial. simpl. apply hAB. now apply IH.
  Qed.
Lemma iter_three k (A : (list R -> R) -> list R -> R) (B : (R -> R -> R -> R) -> R -> R -> R -> R) :
  (forall g h, (forall u v w, g [u; v; w] = h u v w) -> forall u v w, A g [u; v; w] = B h u v w) ->
  forall g h, (forall u v w, g [u; v; w] = h u v w) ->
  forall u v w, Nat.iter k A g [u; v; w] = Nat.iter k B h u v w.
Proof. intro hAB. induction k as [|k IH]; intros g h e; trivial. simpl. apply hAB. now apply IH.
  Qed.
Lemma jet_of_two f o p u v :
  jet 0 [o; p] f [u; v] = Nat.iter o D_u (Nat.iter p D_v (fun u v => f [u; v])) u v.
Proof.
  apply (iter_two o (partial 0) D_u).
  - intros g h e x y. apply Derive_ext. intro t. apply e.
  - apply (iter_two p (partial 1) D_v); trivial. intros g h e x y. apply Derive_ext. intro t.
      apply e.
Qed.
Lemma jet_of_three f o p q u v w : jet 0 [o; p; q] f [u; v; w] =
  Nat.iter o D_1 (Nat.iter p D_2 (Nat.iter q D_3 (fun u v w => f [u; v; w]))) u v w.
Proof.
  apply (iter_three o (partial 0) D_1); [|apply (iter_three p (partial 1) D_2);
    [|apply (iter_three q (partial 2) D_3); trivial]];
    intros g h e x y z; apply Derive_ext; intro t; apply e.
Qed.

Lemma chain_of_one f n o (a : R -> R) x d : smooth n (fun t => f [t]) -> (o < n)%nat ->
  is_derive a x d ->
  is_derive (fun t => jet 0 [o] f [a t]) x (chain f [o] [a x] 0 [d]).
Proof.
  intros h hn ha. cbn [chain bump set nth].
  apply is_derive_ext with (fun t => Nat.iter o Derive (fun t => f [t]) (a t)).
  - intro t. now rewrite jet_of_one.
  - rewrite jet_of_one, Rplus_0_r, Rmult_comm.
    apply (is_derive_comp (Nat.iter o Derive (fun t => f [t])) a x); trivial.
    apply Derive_correct, h, hn.
Qed.
Lemma chain_of_two f n o p (a b : R -> R) x d e : smooth2 n (fun u v => f [u;
  v]) -> (o + p < n)%nat ->
  is_derive a x d -> is_derive b x e ->
  is_derive (fun t => jet 0 [o; p] f [a t; b t]) x (chain f [o; p] [a x; b x] 0 [d; e]).
Proof.
  intros h hn ha hb. cbn [chain bump set nth]. set (r := fun u v => f [u; v]) in *.
  pose proof (smooth_le _ smooth2 smooth2_less n (o + S p) r ltac:(lia) h) as h1.
  assert (h2 : smooth2 (S o) (Nat.iter p D_v r)).
  { apply (smooth_iter _ smooth2 D_v smooth2_v). now replace (p + S o)%nat with (o + S p)%nat by
    lia. }
  assert (h3 : smooth2 1 (Nat.iter o D_u (Nat.iter p D_v r))).
  { apply (smooth_iter _ smooth2 D_u smooth2_u). now rewrite Nat.add_1_r. }
  pose proof (chain2 _ a b x d e h3 ha hb) as C.
  apply is_derive_ext with (fun t => Nat.iter o D_u (Nat.iter p D_v r) (a t) (b t)).
  - intro t. now rewrite jet_of_two.
  - rewrite !jet_of_two, Rplus_0_r. fold r.
    rewrite (move _ smooth2 D_u D_v smooth2_less smooth2_u swap2 o _ h2) in C. exact C.
Qed.
Lemma chain_of_three f n o p q (a b c : R -> R) x d e g : smooth3 n (fun u v w => f [u; v; w]) ->
  (o + (p + q) < n)%nat -> is_derive a x d -> is_derive b x e -> is_derive c x g ->
  is_derive (fun t => jet 0 [o; p; q] f [a t; b t; c t]) x (chain f [o; p; q] [a x; b x;
    c x] 0 [d; e; g]).
Proof.
  intros h hn ha hb hc. cbn [chain bump set nth]. set (r := fun u v w => f [u; v; w]) in *.
  pose proof (smooth_le _ smooth3 smooth3_less n (q + (p + S o)) r ltac:(lia) h) as h1.
  pose proof (smooth_iter _ smooth3 D_3 smooth3_3 q _ _ h1) as h2.
  pose proof (smooth_iter _ smooth3 D_2 smooth3_2 p _ _ h2) as h3.
  assert (h4 : smooth3 1 (Nat.iter o D_1 (Nat.iter p D_2 (Nat.iter q D_3 r)))).
  { apply (smooth_iter _ smooth3 D_1 smooth3_1). now rewrite Nat.add_1_r. }
  pose proof (chain3 _ a b c x d e g h4 ha hb hc) as C.
  apply is_derive_ext with (fun t => Nat.iter o D_1 (Nat.iter p D_2 (Nat.iter q D_3 r)) (a t)
    (b t) (c t)).
  - intro t. now rewrite jet_of_three.
  - rewrite !jet_of_three, Rplus_0_r. fold r.
    rewrite (move _ smooth3 D_1 D_2 smooth3_less smooth3_1 swap3_12 o _ h3) in C.
    rewrite (move _ smooth3 D_1 D_3 smooth3_less smooth3_1 swap3_13 o _ h3) in C.
    rewrite (move _ smooth3 D_2 D_3 smooth3_less smooth3_2 swap3_23 p) in C; [exact C|].
    eapply (smooth_le _ smooth3 smooth3_less); [|exact h2]. lia.
Qed.

Theorem jet_chain s f orders (A : list (R -> R)) (slopes : list R) x :
  smooth_at s f -> differentiable_jet s orders = true -> length A = length orders ->
  Forall2 (fun a d => is_derive a x d) A slopes ->
  is_derive (fun t => jet 0 orders f (map (fun a => a t) A)) x
    (chain f orders (map (fun a => a x) A) 0 slopes).
Proof.
  intros h D L H. destruct s as [[|[|[|[|m]]]] n], orders as [|o [|p [|q [|? ?]]]];
    try discriminate;
    apply Nat.ltb_lt in D; destruct A as [|a [|b [|c [|? ?]]]]; try discriminate;
    inversion H as [|? d ? l ha H1]; subst; inversion H1 as [|? e ? l1 hb H2]; subst;
    try (inversion H2 as [|? g ? l2 hc H3]; subst); try (inversion H3; subst).
  - now apply chain_of_one with n.
  - now apply chain_of_two with n.
  - now apply chain_of_three with n.
Qed.
