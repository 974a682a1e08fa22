(* Expressions that are polynomials in some of their variables. *)
Require Import QArith Lia FunctionalExtensionality.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Expressions PatchProof.Normal.
Require Import PatchProof.Derivatives.
Local Open Scope R_scope.

(* A polynomial in the variables xs; what stands in its coefficients does not contain them. *)
Fixpoint polynomial_in (xs : list positive) (e : ex) : bool :=
  match e with
  | Num _ | At _ => true
  | Plus a b | Minus a b | Times a b => polynomial_in xs a && polynomial_in xs b
  | Negate a | Power a _ => polynomial_in xs a
  | _ => forallb (fun x => negb (occurs x e)) xs
  end.

Lemma free_denominators x e : occurs x e = false -> denominators x e = [].
Proof.
  induction e using ex_induction; cbn [occurs denominators]; intro h; trivial;
    try (apply orb_false_elim in h; destruct h; now rewrite IHe1, IHe2); try (now apply IHe).
  - apply existsb_false in h. induction l as [|a l IH]; trivial. inversion H; inversion h; subst.
      simpl.
    rewrite H2 by trivial. now apply IH.
  - now rewrite h.
Qed.
Lemma free_in xs x e : In x xs -> forallb (fun x => negb (occurs x e)) xs = true ->
  occurs x e = false.
Proof. intros i h. rewrite forallb_forall in h. specialize (h x i). now apply negb_true_iff. Qed.
Lemma free_differentiable S x e : occurs x e = false -> differentiable S x e = true.
Proof.
  induction e using ex_induction; cbn [occurs differentiable]; intro h; trivial;
    try (apply orb_false_elim in h; destruct h; now rewrite IHe1, IHe2); try (now apply IHe).
  - now rewrite h.
  - now rewrite h.
Qed.
Lemma polynomial_differentiable S xs x e : In x xs -> polynomial_in xs e = true ->
  differentiable S x e = true /\ denominators x e = [].
Proof.
  intro i. induction e using ex_induction; intro h; cbn [polynomial_in] in h; try (now split);
    try (apply andb_prop in h; destruct h as [h1 h2]; destruct (IHe1 h1) as [a1 a2];
      destruct (IHe2 h2) as [b1 b2];
      cbn [differentiable denominators]; now rewrite a1, a2, b1, b2);
    try (now apply IHe);
    apply (free_in xs x _ i) in h; split; [now apply free_differentiable|now apply free_denominators
      |now apply free_differentiable|now apply free_denominators|now apply free_differentiable|now
        apply free_denominators].
Qed.
Lemma added_polynomial xs a b :
  polynomial_in xs a = true -> polynomial_in xs b = true -> polynomial_in xs (added a b) = true.
Proof.
  intros ha hb. unfold added. destruct a as [[[|p|p] d]| | | | | | | | |],
    b as [[[|q|q] d']| | | | | | | | |];
    trivial; cbn [polynomial_in] in *; now rewrite ?ha, ?hb.
Qed.
Lemma multiplied_polynomial xs a b :
  polynomial_in xs a = true -> polynomial_in xs b = true ->
    polynomial_in xs (multiplied a b) = true.
Proof.
  intros ha hb. unfold multiplied.
  destruct a as [[[|[p|p|]|p] [d|d|]]| | | | | | | | |], b as [[[|q|q] d']| | | |[[[|q|q] d']| | |
    | | | | | |] b2| | | | |];
    trivial; cbn [polynomial_in andb] in *; now rewrite ?ha, ?hb.
Qed.
Lemma polynomial_derivative xs x e : In x xs -> polynomial_in xs e = true ->
  polynomial_in xs (derivative x e) = true.
Proof.
  intro i. induction e using ex_induction; intro h; cbn [polynomial_in derivative] in *; trivial;
    try (apply andb_prop in h; destruct h as [h1 h2]).
  - now destruct (Pos.eqb p x).
  - apply added_polynomial; auto.
  - now rewrite IHe1, IHe2.
  - apply added_polynomial; apply multiplied_polynomial; auto.
  - auto.
  - destruct n; trivial. apply multiplied_polynomial; trivial. apply multiplied_polynomial; auto.
  - apply (free_in xs x _ i) in h. cbn [occurs] in h. now rewrite h.
  - apply (free_in xs x _ i) in h. cbn [occurs] in h. now rewrite h.
Qed.
