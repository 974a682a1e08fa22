(* Expressions as fractions: a polynomial over a product of powers of polynomials. *)
Require Import QArith Qreals Qreduction Lia Lra micromega.EnvRing.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal.
Local Open Scope R_scope.

Definition factors : Type := list (poly * nat).
(* The exponent of p, and the other factors. *)
Fixpoint extract (p : poly) (d : factors) : nat * factors :=
  match d with
  | [] => (O, [])
  | (q, k) :: d' => if same p q then (k, d') else let (m, r) := extract p d' in (m, (q, k) :: r)
  end.
Fixpoint merge (c d : factors) : factors :=
  match c with [] => d | (p, k) :: c' => let (m, r) := extract p d in (p,
    k + m)%nat :: merge c' r end.
(* The least common multiple, and what c and d have to be multiplied with. *)
Fixpoint common (c d : factors) : factors * poly * poly :=
  match c with
  | [] => (d, fold_right (fun f r => pmul (ppow (fst f) (snd f)) r) (constant 1) d, constant 1)
  | (p, k) :: c' =>
      let (m, r) := extract p d in
      let '(l, x, y) := common c' r in
      let n := Nat.max k m in
      ((p, n) :: l, pmul (ppow p (n - k)) x, pmul (ppow p (n - m)) y)
  end.
Definition expand (d : factors) : poly := fold_right (fun f r => pmul (ppow (fst f) (snd f)) r)
  (constant 1) d.

Definition fraction : Type := poly * factors.
Definition combine (f : poly -> poly -> poly) (a b : fraction) : fraction :=
  let '(d, x, y) := common (snd a) (snd b) in (f (pmul (fst a) x) (pmul (fst b) y), d).
(* The inverse of a polynomial that is a constant different from 0. *)
Definition unit_inverse (p : poly) : option Q :=
  match p with Pc q => if Qeq_bool q 0 then None else Some (Qred (/ q)) | _ => None end.
Fixpoint has_inverse (e : ex) : bool :=
  match e with
  | Plus a b | Minus a b | Times a b => has_inverse a || has_inverse b
  | Negate a | Power a _ => has_inverse a
  | Inverse _ => true
  | _ => false
  end.
Fixpoint as_fraction (T : list ex) (e : ex) : fraction :=
  if negb (has_inverse e) then (polynomial T e, []) else
  match e with
  | Plus a b => combine padd (as_fraction T a) (as_fraction T b)
  | Minus a b => combine psub (as_fraction T a) (as_fraction T b)
  | Times a b => let (n, d) := as_fraction T a in let (m, c) :=
    as_fraction T b in (pmul n m, merge d c)
  | Negate a => let (n, d) := as_fraction T a in (popp n, d)
  | Power a k => let (n, d) := as_fraction T a in (ppow n k, map (fun f => (fst f,
    (snd f * k)%nat)) d)
  | Inverse a => let (n, d) := as_fraction T a in
      match unit_inverse n with
      | Some q => (pmul (constant q) (expand d), [])
      | None => (expand d, [(n, 1%nat)])
      end
  | _ => (polynomial T e, [])
  end.
(* Everything that was divided by and is no constant. *)
Fixpoint divisors (T : list ex) (e : ex) : list poly :=
  match e with
  | Plus a b | Minus a b | Times a b => divisors T a ++ divisors T b
  | Negate a | Power a _ => divisors T a
  | Inverse a => let n := fst (as_fraction T a) in
      match unit_inverse n with Some _ => divisors T a | None => n :: divisors T a end
  | _ => []
  end.
(* The atoms other than inverses. *)
Fixpoint inner_atoms (e : ex) : list ex :=
  match e with
  | Num _ | At _ => []
  | Plus a b | Minus a b | Times a b => inner_atoms a ++ inner_atoms b
  | Negate a | Power a _ | Inverse a => inner_atoms a
  | _ => [e]
  end.

Section Values.
Variable Phi : list (list R -> R).
Variable rho : positive -> R.
Variable T : list ex.
Notation pvalue := (pvalue (places Phi rho T)).
Notation eval := (eval Phi rho).

Fixpoint product (d : factors) : R :=
  match d with [] => 1 | (p, k) :: d' => pvalue p ^ k * product d' end.
Lemma expand_value d : pvalue (expand d) = product d.
Proof.
  induction d as [|[p k] d IH]; [apply one_value|]. unfold expand. simpl fold_right.
  rewrite pmul_value, ppow_value. unfold expand in IH. now rewrite IH.
Qed.
Lemma extract_value p d : product d = pvalue p ^ fst (extract p d) * product (snd (extract p d)).
Proof.
  induction d as [|[q k] d IH]; simpl; [ring|]. destruct (same p q) eqn:E; simpl.
  - now rewrite (same_value _ p q E).
  - destruct (extract p d) as [m r]. simpl in *. rewrite IH. ring.
Qed.
Lemma merge_value c : forall d, product (merge c d) = product c * product d.
Proof.
  induction c as [|[p k] c IH]; intro d; simpl; [ring|]. pose proof (extract_value p d) as h.
  destruct (extract p d) as [m r]. simpl in *. rewrite h, IH, pow_add. ring.
Qed.
Lemma power_split (a : R) (k n : nat) : (k <= n)%nat -> a ^ n = a ^ k * a ^ (n - k).
Proof. intro h. rewrite <- pow_add. f_equal. lia. Qed.
Lemma common_value c : forall d l x y, common c d = (l, x, y) ->
  product l = product c * pvalue x /\ product l = product d * pvalue y.
Proof.
  induction c as [|[p k] c IH]; intros d l x y h; simpl in h.
  - injection h as <- <- <-. rewrite (expand_value d : pvalue (fold_right _ _ _) = _),
      constant_value. simpl.
    rewrite one_value. split; ring.
  - pose proof (extract_value p d) as e. destruct (extract p d) as [m r].
    destruct (common c r) as [[l' x'] y'] eqn:E. injection h as <- <- <-. apply IH in E.
      destruct E as [E1 E2].
    cbn [product fst snd] in *. rewrite !pmul_value, !ppow_value. split.
    + rewrite E1, (power_split _ k (Nat.max k m)) by lia. ring.
    + rewrite E2, e, (power_split _ m (Nat.max k m)) by lia. ring.
Qed.

Definition nonzero_factors (d : factors) : Prop := Forall (fun f => pvalue (fst f) <> 0) d.
Lemma nonzero_product d : nonzero_factors d -> product d <> 0.
Proof.
  induction 1 as [|[p k] d h _ IH]; simpl; [apply R1_neq_R0|].
  apply Rmult_integral_contrapositive_currified; trivial. now apply pow_nonzero.
Qed.
Lemma nonzero_extract p d : nonzero_factors d -> nonzero_factors (snd (extract p d)).
Proof.
  induction 1 as [|[q k] d h h' IH]; simpl; [constructor|]. destruct (same p q); [exact h'|].
  destruct (extract p d). now constructor.
Qed.
Lemma nonzero_merge c : forall d, nonzero_factors c -> nonzero_factors d ->
  nonzero_factors (merge c d).
Proof.
  induction c as [|[p k] c IH]; intros d hc hd; trivial. inversion hc; subst. simpl.
  pose proof (nonzero_extract p d hd). destruct (extract p d). constructor; simpl in *; auto.
    now apply IH.
Qed.
Lemma nonzero_common c : forall d l x y, common c d = (l, x, y) ->
  nonzero_factors c -> nonzero_factors d -> nonzero_factors l.
Proof.
  induction c as [|[p k] c IH]; intros d l x y h hc hd; simpl in h.
  - now injection h as <- <- <-.
  - inversion hc; subst. pose proof (nonzero_extract p d hd). destruct (extract p d) as [m r].
    destruct (common c r) as [[l' x'] y'] eqn:E. injection h as <- <- <-. constructor; trivial.
      eapply IH; eauto.
Qed.

Definition stands_for (f : fraction) (x : R) : Prop :=
  x * product (snd f) = pvalue (fst f) /\ nonzero_factors (snd f).

Lemma combine_value f (g : R -> R -> R) a b x y :
  (forall p q, pvalue (f p q) = g (pvalue p) (pvalue q)) ->
    (forall x y z, g x y * z = g (x * z) (y * z)) ->
  stands_for a x -> stands_for b y -> stands_for (combine f a b) (g x y).
Proof.
  intros hf hg [a1 a2] [b1 b2]. unfold combine, stands_for.
  destruct (common (snd a) (snd b)) as [[d p] q] eqn:E. pose proof (common_value _ _ _ _ _ E)
    as [E1 E2].
  cbn [fst snd]. rewrite hf, hg, !pmul_value, <- a1, <- b1. split.
  - f_equal; [rewrite E1|rewrite E2]; ring.
  - eapply nonzero_common; eassumption.
Qed.
Lemma unit_inverse_value p q : unit_inverse p = Some q -> Q2R q = / pvalue p /\ pvalue p <> 0.
Proof.
  destruct p as [c| |]; try discriminate. simpl. destruct (Qeq_bool c 0) eqn:E; try discriminate.
  intros [= <-]. rewrite (Qeq_eqR _ _ (Qred_correct _)). apply Qeq_bool_neq in E.
  rewrite Q2R_inv by exact E. split; trivial. change (Q2R c <> 0). rewrite <- zero_value. intro h.
  now apply E, eqR_Qeq.
Qed.
Lemma power_factors d k : product (map (fun f => (fst f, (snd f * k)%nat)) d) = product d ^ k.
Proof.
  induction d as [|[p m] d IH]; simpl; [symmetry; apply pow1|].
    now rewrite IH, Rpow_mult_distr, pow_mult.
Qed.
Lemma polynomial_fraction e : Forall (fun a => In a T) (atoms e) ->
  stands_for (polynomial T e, []) (eval e).
Proof. intro h. split; simpl; [rewrite Rmult_1_r; symmetry;
  now apply polynomial_value|constructor]. Qed.

Definition nonzero_polys (l : list poly) : Prop := Forall (fun p => pvalue p <> 0) l.
Lemma in_app {A} (l m : list A) (P : A -> Prop) : Forall P (l ++ m) -> Forall P l /\ Forall P m.
Proof. apply Forall_app. Qed.
Lemma free_atoms e : has_inverse e = false -> atoms e = inner_atoms e.
Proof.
  induction e; cbn [has_inverse atoms inner_atoms]; intro h; trivial; try discriminate; auto;
    apply orb_false_elim in h; destruct h; now rewrite IHe1, IHe2.
Qed.
Lemma free_fraction e : negb (has_inverse e) = true -> Forall (fun a => In a T) (inner_atoms e) ->
  stands_for (as_fraction T e) (eval e).
Proof.
  intros E h. replace (as_fraction T e) with (polynomial T e, [] : factors).
  - apply polynomial_fraction. rewrite free_atoms; trivial. now apply negb_true_iff.
  - destruct e; cbn [as_fraction]; rewrite E; reflexivity.
Qed.
Theorem as_fraction_value e : Forall (fun a => In a T) (inner_atoms e) ->
  nonzero_polys (divisors T e) ->
  stands_for (as_fraction T e) (eval e).
Proof.
  induction e; intros h nz; match goal with |- stands_for (as_fraction T ?e) _ =>
      destruct (negb (has_inverse e)) eqn:F; [now apply free_fraction|]; try discriminate;
      cbn [as_fraction]; rewrite F; clear F end;
    cbn [inner_atoms divisors] in h, nz;
    try (apply in_app in h; destruct h as [h1 h2]; apply in_app in nz; destruct nz as [n1 n2]).
  - apply combine_value; auto using padd_value. intros; ring.
  - apply combine_value; auto using psub_value. intros; ring.
  - specialize (IHe1 h1 n1). specialize (IHe2 h2 n2).
    destruct (as_fraction T e1) as [p d], (as_fraction T e2) as [q c].
      destruct IHe1 as [a1 a2], IHe2 as [b1 b2].
    cbn [fst snd] in *. split; cbn [fst snd eval].
    + rewrite pmul_value, merge_value, <- a1, <- b1. ring.
    + now apply nonzero_merge.
  - specialize (IHe h nz). destruct (as_fraction T e) as [p d]. destruct IHe as [a1 a2].
    cbn [fst snd] in *. split; cbn [fst snd eval]; trivial. rewrite popp_value, <- a1. ring.
  - specialize (IHe h nz). destruct (as_fraction T e) as [p d].
    destruct IHe as [a1 a2]. cbn [fst snd] in *. split; cbn [fst snd eval].
    + now rewrite ppow_value, power_factors, <- a1, Rpow_mult_distr.
    + clear - a2. induction a2; simpl; constructor; trivial.
  - cbn [eval]. destruct (unit_inverse (fst (as_fraction T e))) as [q|] eqn:E.
    + specialize (IHe h nz). destruct (as_fraction T e) as [p d]. destruct IHe as [a1 a2].
        cbn [fst snd] in *.
      rewrite E. apply unit_inverse_value in E. destruct E as [E1 E2]. split; [|constructor].
        cbn [fst snd product].
      rewrite pmul_value, constant_value, E1, <- a1, expand_value.
        pose proof (nonzero_product d a2).
      field. split; trivial. intro z. apply E2. rewrite <- a1, z. ring.
    + inversion nz as [|? ? n1 n2]; subst. specialize (IHe h n2).
        destruct (as_fraction T e) as [p d].
      destruct IHe as [a1 a2]. cbn [fst snd] in *. rewrite E.
      split; [|constructor; [exact n1|constructor]]. cbn [fst snd product].
      rewrite expand_value, <- a1. field. intro z. apply n1. rewrite <- a1, z. ring.
Qed.
End Values.
