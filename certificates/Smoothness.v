(* Functions of two and of three arguments: the order of partial derivatives does not matter,
  and the chain rule. *)
Require Import Lra Lia.
From Coquelicot Require Import Rcomplements Derive_2d.
Require Import FunctionalExtensionality.
Require Import PatchProof.Definitions.
Local Open Scope R_scope.

(* The increment in one place: F is differentiable in its second argument,
  a is differentiable at x. *)
Lemma increment_derivative (F F' : R -> R -> R) (a : R -> R) (x d : R) :
  (forall t y, is_derive (F t) y (F' t y)) -> continuous2 F' x (a x) -> is_derive a x d ->
  is_derive (fun t => F t (a t) - F t (a x)) x (F' x (a x) * d).
Proof.
  intros hF hc ha. apply is_derive_Reals in ha. apply is_derive_Reals. intros eps he.
  set (L := F' x (a x)) in *.
  assert (hL : 0 <= Rabs L) by apply Rabs_pos. assert (hd : 0 <= Rabs d) by apply Rabs_pos.
  set (e1 := Rmin 1 (eps / (2 * (Rabs L + 1)))).
  assert (he1 : 0 < e1) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]).
  assert (m1 : e1 <= 1) by apply Rmin_l. assert (m2 : e1 <= eps / (2 * (Rabs L + 1)))
    by apply Rmin_r.
  set (e2 := eps / (2 * (Rabs d + 1))). assert (he2 : 0 < e2) by (apply Rdiv_lt_0_compat; lra).
  destruct (hc e2 he2) as [d2 [hd2 H2]]. destruct (ha e1 he1) as [d1 H1].
  (* a is continuous at x. *)
  assert (C : exists d3, 0 < d3 /\ forall h, Rabs h < d3 -> Rabs (a (x + h) - a x) < d2).
  { assert (c : continuity_pt a x) by (apply derivable_continuous_pt; exists d; exact ha).
    destruct (c d2 hd2) as [d3 [hd3 H3]]. exists d3. split; [exact hd3|]. intros h hh.
    destruct (Req_dec h 0) as [->|ne]; [rewrite Rplus_0_r, Rminus_eq_0, Rabs_R0; exact hd2|].
    apply (H3 (x + h)). split; [split; [exact I|lra]|]. simpl. unfold R_dist.
      now replace (x + h - x) with h by ring. }
  destruct C as [d3 [hd3 H3]].
  assert (hm : 0 < Rmin d1 (Rmin d2 d3)) by (repeat apply Rmin_glb_lt; trivial; apply cond_pos).
  exists (mkposreal _ hm). intros h h0 hh. simpl in hh.
  pose proof (Rmin_l d1 (Rmin d2 d3)). pose proof (Rmin_r d1 (Rmin d2 d3)).
  pose proof (Rmin_l d2 d3). pose proof (Rmin_r d2 d3).
  assert (q1 : Rabs ((a (x + h) - a x) / h - d) < e1) by (apply H1; trivial; lra).
  (* The mean value theorem. *)
  destruct (MVT_gen (F (x + h)) (a x) (a (x + h)) (F' (x + h))) as [xi [hxi E]].
  { intros y _. apply hF. }
  { intros y _. apply derivable_continuous_pt. exists (F' (x + h) y). apply is_derive_Reals, hF. }
  replace (F (x + h) (a (x + h)) - F (x + h) (a x) - (F x (a x) - F x (a x)))
    with (F' (x + h) xi * (a (x + h) - a x)) by lra.
  assert (q2 : Rabs (F' (x + h) xi - L) < e2).
  { apply H2.
    - replace (x + h - x) with h by ring. lra.
    - apply Rle_lt_trans with (Rabs (a (x + h) - a x)); [|apply H3; lra].
      revert hxi. unfold Rmin, Rmax. destruct (Rle_dec (a x) (a (x + h))) as [l|l]; intros [g1 g2].
      + rewrite !Rabs_pos_eq; lra.
      + apply Rnot_le_lt in l. rewrite !Rabs_left1; lra. }
  set (s := (a (x + h) - a x) / h) in *. replace (F' (x + h) xi * (a (x + h) - a x) / h)
    with (F' (x + h) xi * s)
    by (unfold s; field; exact h0).
  replace (F' (x + h) xi * s - L * d) with ((F' (x + h) xi - L) * s + L * (s - d)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
  assert (hs : Rabs s < Rabs d + 1).
  { replace s with ((s - d) + d) by ring. eapply Rle_lt_trans; [apply Rabs_triang|].
    lra. }
  assert (p1 : Rabs (F' (x + h) xi - L) * Rabs s <= e2 * (Rabs d + 1)).
  { apply Rmult_le_compat; try apply Rabs_pos; lra. }
  assert (p2 : Rabs L * Rabs (s - d) <= Rabs L * (eps / (2 * (Rabs L + 1)))).
  { apply Rmult_le_compat_l; trivial. lra. }
  assert (p3 : e2 * (Rabs d + 1) = eps / 2) by (unfold e2; field; lra).
  assert (p4 : Rabs L * (eps / (2 * (Rabs L + 1))) < eps / 2).
  { replace (Rabs L * (eps / (2 * (Rabs L + 1)))) with (eps / 2 * (Rabs L / (Rabs L + 1)))
    by (field; lra).
    rewrite <- (Rmult_1_r (eps / 2)) at 2. apply Rmult_lt_compat_l; [lra|]. apply Rlt_div_l; lra. }
  lra.
Qed.

Lemma continuous_at (a : R -> R) x d : is_derive a x d ->
  forall eps, 0 < eps -> exists delta, 0 < delta /\ forall t, Rabs (t - x) < delta ->
    Rabs (a t - a x) < eps.
Proof.
  intros h eps he. assert (c : continuous a x) by (apply @ex_derive_continuous; now exists d).
  destruct (proj1 (filterlim_locally a (a x)) c (mkposreal eps he)) as [delta H].
  exists delta. split; [apply cond_pos|]. intros t ht. exact (H t ht).
Qed.
Lemma smaller (d1 d2 : R) : 0 < d1 -> 0 < d2 -> exists d, 0 < d /\ d <= d1 /\ d <= d2.
Proof.
  intros h1 h2. exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|].
    split; [apply Rmin_l|apply Rmin_r].
Qed.

Theorem chain2 (r : R -> R -> R) (a b : R -> R) (x d e : R) : smooth2 1 r -> is_derive a x d ->
  is_derive b x e ->
  is_derive (fun t => r (a t) (b t)) x (D_u r (a x) (b x) * d + D_v r (a x) (b x) * e).
Proof.
  intros [_ [h [[hu _] _]]] ha hb.
  apply is_derive_ext with (fun t => plus (minus (r (a t) (b t)) (r (a x) (b t))) (r (a x) (b t))).
  - intro t. change (r (a t) (b t) - r (a x) (b t) + r (a x) (b t) = r (a t) (b t)). ring.
  - apply @is_derive_plus.
    + apply (increment_derivative (fun t y => r y (b t)) (fun t y => D_u r y (b t))); trivial.
      * intros t y. exact (Derive_correct _ _ (proj1 (h y (b t)))).
      * intros eps he. destruct (hu (a x) (b x) eps he) as [d1 [h1 H1]].
        destruct (continuous_at b x e hb d1 h1) as [d2 [h2 H2]].
          destruct (smaller d1 d2 h1 h2) as [d3 [h3 [l1 l2]]].
        exists d3. split; trivial. intros t y ht hy. apply H1; [lra|]. apply H2. lra.
    + rewrite Rmult_comm. apply (is_derive_comp (fun y => r (a x) y) b x); trivial.
      exact (Derive_correct _ _ (proj2 (h (a x) (b x)))).
Qed.

Theorem chain3 (r : R -> R -> R -> R) (a b c : R -> R) (x d e f : R) :
  smooth3 1 r -> is_derive a x d -> is_derive b x e -> is_derive c x f ->
  is_derive (fun t => r (a t) (b t) (c t)) x
    (D_1 r (a x) (b x) (c x) * d + (D_2 r (a x) (b x) (c x) * e + D_3 r (a x) (b x) (c x) * f)).
Proof.
  intros [_ [h [[h1 _] [[h2 _] _]]]] ha hb hc.
  apply is_derive_ext with (fun t => plus (minus (r (a t) (b t) (c t)) (r (a x) (b t) (c t)))
    (plus (minus (r (a x) (b t) (c t)) (r (a x) (b x) (c t))) (r (a x) (b x) (c t)))).
  - intro t. change (r (a t) (b t) (c t) - r (a x) (b t) (c t) + (r (a x) (b t) (c t) - r (a x)
      (b x) (c t)
      + r (a x) (b x) (c t)) = r (a t) (b t) (c t)). ring.
  - apply @is_derive_plus; [|apply @is_derive_plus].
    + apply (increment_derivative (fun t y => r y (b t) (c t)) (fun t y => D_1 r y (b t) (c t)));
        trivial.
      * intros t y. exact (Derive_correct _ _ (proj1 (h y (b t) (c t)))).
      * intros eps he. destruct (h1 (a x) (b x) (c x) eps he) as [d1 [p1 H1]].
        destruct (continuous_at b x e hb d1 p1) as [d2 [p2 H2]].
        destruct (continuous_at c x f hc d1 p1) as [d3 [p3 H3]].
        destruct (smaller d1 d2 p1 p2) as [d4 [p4 [l1 l2]]].
          destruct (smaller d4 d3 p4 p3) as [d5 [p5 [l3 l4]]].
        exists d5. split; trivial. intros t y ht hy. apply H1; [lra|apply H2; lra|apply H3; lra].
    + apply (increment_derivative (fun t y => r (a x) y (c t)) (fun t y => D_2 r (a x) y (c t)));
        trivial.
      * intros t y. exact (Derive_correct _ _ (proj1 (proj2 (h (a x) y (c t))))).
      * intros eps he. destruct (h2 (a x) (b x) (c x) eps he) as [d1 [p1 H1]].
        destruct (continuous_at c x f hc d1 p1) as [d3 [p3 H3]].
        destruct (smaller d1 d3 p1 p3) as [d5 [p5 [l3 l4]]].
        exists d5. split; trivial. intros t y ht hy.
        apply H1; [rewrite Rminus_eq_0, Rabs_R0; lra|lra|apply H3; lra].
    + rewrite Rmult_comm. apply (is_derive_comp (fun y => r (a x) (b x) y) c x); trivial.
      exact (Derive_correct _ _ (proj2 (proj2 (h (a x) (b x) (c x))))).
Qed.

(* Fewer derivatives. *)
Lemma smooth2_less n r : smooth2 (S n) r -> smooth2 n r.
Proof.
  revert r. induction n as [|n IH]; intros r h; [now destruct h|].
  destruct h as [h0 [h1 [h2 h3]]]. split; trivial. split; trivial. split; now apply IH.
Qed.
Lemma smooth3_less n r : smooth3 (S n) r -> smooth3 n r.
Proof.
  revert r. induction n as [|n IH]; intros r h; [now destruct h|].
  destruct h as [h0 [h1 [h2 [h3 h4]]]]. split; trivial. split; trivial. repeat split; now apply IH.
Qed.

Lemma continuous2_continuity r u v : continuous2 r u v -> continuity_2d_pt r u v.
Proof.
  intros h eps. destruct (h eps (cond_pos eps)) as [d [hd H]]. exists (mkposreal d hd).
    intros x y hx hy. now apply H.
Qed.
(* The two orders of differentiation. *)
Lemma mixed (f : R -> R -> R) u v :
  (forall u v, ex_derive (fun t => f t v) u /\ ex_derive (fun t => f u t) v) ->
  (forall u v, ex_derive (fun t => D_u f u t) v) -> (forall u v,
    ex_derive (fun t => D_v f t v) u) ->
  continuous2 (D_v (D_u f)) u v -> continuous2 (D_u (D_v f)) u v ->
    D_v (D_u f) u v = D_u (D_v f) u v.
Proof.
  intros h h1 h2 c1 c2. symmetry. apply (Schwarz f u v).
  - exists (mkposreal 1 Rlt_0_1). intros x y _ _.
    exact (conj (proj1 (h x y)) (conj (proj2 (h x y)) (conj (h2 x y) (h1 x y)))).
  - exact (continuous2_continuity _ _ _ c2).
  - exact (continuous2_continuity _ _ _ c1).
Qed.
Lemma smooth2_continuous n r : smooth2 n r -> forall u v, continuous2 r u v.
Proof. destruct n; intros [h _]; exact h. Qed.
Lemma smooth3_continuous n r : smooth3 n r -> forall u v w, continuous3 r u v w.
Proof. destruct n; intros [h _]; exact h. Qed.
Lemma smooth2_u n r : smooth2 (S n) r -> smooth2 n (D_u r).
Proof. intros [_ [_ [h _]]]. exact h. Qed.
Lemma smooth2_v n r : smooth2 (S n) r -> smooth2 n (D_v r).
Proof. intros [_ [_ [_ h]]]. exact h. Qed.
Lemma smooth3_1 n r : smooth3 (S n) r -> smooth3 n (D_1 r).
Proof. intros [_ [_ [h _]]]. exact h. Qed.
Lemma smooth3_2 n r : smooth3 (S n) r -> smooth3 n (D_2 r).
Proof. intros [_ [_ [_ [h _]]]]. exact h. Qed.
Lemma smooth3_3 n r : smooth3 (S n) r -> smooth3 n (D_3 r).
Proof. intros [_ [_ [_ [_ h]]]]. exact h. Qed.
Lemma smooth2_derivatives n r : smooth2 (S n) r -> forall u v,
  ex_derive (fun t => r t v) u /\ ex_derive (fun t => r u t) v.
Proof. intros [_ [h _]]. exact h. Qed.
Lemma smooth3_derivatives n r : smooth3 (S n) r -> forall u v w,
  ex_derive (fun t => r t v w) u /\ ex_derive (fun t => r u t w) v /\ ex_derive (fun t => r u v t)
    w.
Proof. intros [_ [h _]]. exact h. Qed.

Lemma swap2 n r : smooth2 (S (S n)) r -> D_v (D_u r) = D_u (D_v r).
Proof.
  intro s. apply functional_extensionality; intro u. apply functional_extensionality; intro v.
  apply (mixed r u v).
  - exact (smooth2_derivatives _ _ s).
  - intros x y. exact (proj2 (smooth2_derivatives _ _ (smooth2_u _ _ s) x y)).
  - intros x y. exact (proj1 (smooth2_derivatives _ _ (smooth2_v _ _ s) x y)).
  - exact (smooth2_continuous _ _ (smooth2_v _ _ (smooth2_u _ _ s)) u v).
  - exact (smooth2_continuous _ _ (smooth2_u _ _ (smooth2_v _ _ s)) u v).
Qed.
(* A continuous function of three arguments is continuous in two of them. *)
Lemma continuous_12 r u v w : continuous3 r u v w -> continuous2 (fun x y => r x y w) u v.
Proof.
  intros c eps he. destruct (c eps he) as [d [hd H]]. exists d. split; trivial. intros x y hx hy.
  apply H; trivial. now rewrite Rminus_eq_0, Rabs_R0.
Qed.
Lemma continuous_13 r u v w : continuous3 r u v w -> continuous2 (fun x y => r x v y) u w.
Proof.
  intros c eps he. destruct (c eps he) as [d [hd H]]. exists d. split; trivial. intros x y hx hy.
  apply H; trivial. now rewrite Rminus_eq_0, Rabs_R0.
Qed.
Lemma continuous_23 r u v w : continuous3 r u v w -> continuous2 (fun x y => r u x y) v w.
Proof.
  intros c eps he. destruct (c eps he) as [d [hd H]]. exists d. split; trivial. intros x y hx hy.
  apply H; trivial. now rewrite Rminus_eq_0, Rabs_R0.
Qed.
Lemma swap3_12 n r : smooth3 (S (S n)) r -> D_2 (D_1 r) = D_1 (D_2 r).
Proof.
  intro s. apply functional_extensionality; intro u. apply functional_extensionality; intro v.
  apply functional_extensionality; intro w. apply (mixed (fun x y => r x y w) u v).
  - intros x y. pose proof (smooth3_derivatives _ _ s x y w) as h.
    exact (conj (proj1 (h)) (proj1 (proj2 (h)))).
  - intros x y. pose proof (smooth3_derivatives _ _ (smooth3_1 _ _ s) x y w) as h.
      exact (proj1 (proj2 (h))).
  - intros x y. pose proof (smooth3_derivatives _ _ (smooth3_2 _ _ s) x y w) as h.
      exact (proj1 (h)).
  - exact (continuous_12 _ _ _ _ (smooth3_continuous _ _ (smooth3_2 _ _ (smooth3_1 _ _ s)) u v w)).
  - exact (continuous_12 _ _ _ _ (smooth3_continuous _ _ (smooth3_1 _ _ (smooth3_2 _ _ s)) u v w)).
Qed.
Lemma swap3_13 n r : smooth3 (S (S n)) r -> D_3 (D_1 r) = D_1 (D_3 r).
Proof.
  intro s. apply functional_extensionality; intro u. apply functional_extensionality; intro v.
  apply functional_extensionality; intro w. apply (mixed (fun x y => r x v y) u w).
  - intros x y. pose proof (smooth3_derivatives _ _ s x v y) as h.
    exact (conj (proj1 (h)) (proj2 (proj2 (h)))).
  - intros x y. pose proof (smooth3_derivatives _ _ (smooth3_1 _ _ s) x v y) as h.
      exact (proj2 (proj2 (h))).
  - intros x y. pose proof (smooth3_derivatives _ _ (smooth3_3 _ _ s) x v y) as h.
      exact (proj1 (h)).
  - exact (continuous_13 _ _ _ _ (smooth3_continuous _ _ (smooth3_3 _ _ (smooth3_1 _ _ s)) u v w)).
  - exact (continuous_13 _ _ _ _ (smooth3_continuous _ _ (smooth3_1 _ _ (smooth3_3 _ _ s)) u v w)).
Qed.
Lemma swap3_23 n r : smooth3 (S (S n)) r -> D_3 (D_2 r) = D_2 (D_3 r).
Proof.
  intro s. apply functional_extensionality; intro u. apply functional_extensionality; intro v.
  apply functional_extensionality; intro w. apply (mixed (fun x y => r u x y) v w).
  - intros x y. pose proof (smooth3_derivatives _ _ s u x y) as h.
    exact (conj (proj1 (proj2 (h))) (proj2 (proj2 (h)))).
  - intros x y. pose proof (smooth3_derivatives _ _ (smooth3_2 _ _ s) u x y) as h.
      exact (proj2 (proj2 (h))).
  - intros x y. pose proof (smooth3_derivatives _ _ (smooth3_3 _ _ s) u x y) as h.
      exact (proj1 (proj2 (h))).
  - exact (continuous_23 _ _ _ _ (smooth3_continuous _ _ (smooth3_3 _ _ (smooth3_2 _ _ s)) u v w)).
  - exact (continuous_23 _ _ _ _ (smooth3_continuous _ _ (smooth3_2 _ _ (smooth3_3 _ _ s)) u v w)).
Qed.

(* A derivative moves past many derivatives of another kind. *)
Section Commutation.
Variable X : Type.
Variable smooth_ : nat -> X -> Prop.
Variables A B : X -> X.
Hypothesis less : forall n f, smooth_ (S n) f -> smooth_ n f.
Hypothesis smooth_A : forall n f, smooth_ (S n) f -> smooth_ n (A f).
Hypothesis swap : forall n f, smooth_ (S (S n)) f -> B (A f) = A (B f).
Lemma smooth_le n m f : (m <= n)%nat -> smooth_ n f -> smooth_ m f.
Proof. induction 1; auto. Qed.
Lemma smooth_iter k : forall n f, smooth_ (k + n) f -> smooth_ n (Nat.iter k A f).
Proof. induction k as [|k IH]; intros n f h; trivial. apply smooth_A, IH.
  now rewrite Nat.add_succ_r. Qed.
Lemma move k f : smooth_ (S k) f -> B (Nat.iter k A f) = Nat.iter k A (B f).
Proof.
  induction k as [|k IH]; intro h; trivial. simpl. rewrite (swap 0).
  - f_equal. apply IH. now apply less.
  - apply smooth_iter. eapply smooth_le; [|exact h]. lia.
Qed.
End Commutation.
