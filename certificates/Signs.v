(* Certificates of signs: sums of products of squares and of facts that are known to be
  nonnegative. *)
Require Import QArith Qreals Lra.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Jets PatchProof.Integrals PatchProof.Values
  PatchProof.Vanishing
  PatchProof.Equations.
Local Open Scope R_scope.

(* Facts 0 <= t, or 0 < t with true. *)
Fixpoint all_signs (Phi : list (list R -> R)) (sigma : list R) (l : list (term * bool)) : Prop :=
  match l with
  | [] => True
  | (t, strict) :: l' =>
      (if strict then 0 < denote Phi sigma t else 0 <= denote Phi sigma t) /\ all_signs Phi sigma l'
  end.

(* A rational number times squares of terms times powers of facts, these given by their numbers. *)
Definition summand : Type := Q * list term * list (nat * nat).
(* Summands, and a cofactor for each of the equations that are known. *)
Definition proof : Type := list summand * list term.
Definition Factor (fact exponent : nat) : nat * nat := (fact, exponent).
Definition Summand (q : Q) (squares : list term) (powers : list (nat * nat)) : summand :=
  (q, squares, powers).
Definition Sum (summands : list summand) (cofactors : list term) : proof := (summands, cofactors).
Inductive log : Type :=
  | Done (p : proof)                                      (* the goal is such a sum *)
  | Step (h : term) (strict : bool) (p : proof) (rest : log)   (* h is; it becomes the last fact *)
  | Split (g : term) (nonnegative negative : log).        (* g or its opposite becomes the last
    fact *)

Section Check.
Variable smoothness : list (nat * nat).
Variable n : nat.
Variable K : list (ex * ex).
Variable differences : list (option ex).       (* of the hypotheses *)
Notation known := (list (ex * bool)).

Definition times_fact (facts : known) (f : nat * nat) (e : ex) : ex :=
  Times (Power (fst (nth (fst f) facts (Num 1, true))) (snd f)) e.
Definition summand_value (facts : known) (s : summand) : ex :=
  let '(q, squares, l) := s in
  fold_right (fun t e => Times (Power (data smoothness n t) 2) e)
    (fold_right (times_fact facts) (Num q) l) squares.
(* A fact that is greater than 0, to whatever power, or the power 0 of a fact. *)
Definition positive_factor (facts : known) (f : nat * nat) : bool :=
  snd (nth (fst f) facts (Num 1, true)) || Nat.eqb (snd f) 0.
Definition nonnegative_summand (s : summand) : bool := Qle_bool 0 (fst (fst s)).
Definition positive_summand (facts : known) (s : summand) : bool :=
  let '(q, squares, l) := s in negb (Qle_bool q 0) && empty squares && forallb (positive_factor
    facts) l.
(* Does the combination prove 0 <= e, or 0 < e? *)
Definition proves (facts : known) (p : proof) (e : ex) (strict : bool) : bool :=
  forallb nonnegative_summand (fst p)
  && (negb strict || existsb (positive_summand facts) (fst p))
  && match combination smoothness n (snd p) differences with
     | Some s => vanishes K (normal (Minus e (Plus (fold_right (fun s e => Plus (summand_value
       facts s) e) (Num 0)
         (fst p)) s)))
     | None => false
     end.
Fixpoint check_log (facts : known) (goal : ex) (strict : bool) (l : log) : bool :=
  match l with
  | Done p => proves facts p goal strict
  | Step h s p rest =>
      let e := data smoothness n h in proves facts p e s && check_log (facts ++ [(e,
        s)]) goal strict rest
  | Split g a b =>
      let e := data smoothness n g in
      check_log (facts ++ [(e, false)]) goal strict a && check_log (facts ++ [(Negate e,
        false)]) goal strict b
  end.

Variable Phi : list (list R -> R).
Variable sigma : list R.
Hypothesis known_facts : Forall (fun f => eval Phi (assignment sigma) (snd f) <> 0) K.
Hypothesis combination_zero : forall q s, combination smoothness n q differences = Some s ->
  eval Phi (assignment sigma) s = 0.
Notation eval := (eval Phi (assignment sigma)).

Definition has_sign (x : R) (strict : bool) : Prop := if strict then 0 < x else 0 <= x.
Definition hold (facts : known) : Prop := Forall (fun f => has_sign (eval (fst f)) (snd f)) facts.
Lemma has_sign_le x s : has_sign x s -> 0 <= x.
Proof. destruct s; simpl; lra. Qed.
Lemma hold_nth facts i : hold facts -> has_sign (eval (fst (nth i facts (Num 1,
  true)))) (snd (nth i facts (Num 1, true))).
Proof.
  intro h. destruct (Nat.ltb_spec i (length facts)) as [l|l].
  - unfold hold in h. rewrite Forall_forall in h. apply h. now apply nth_In.
  - rewrite nth_overflow by exact l. simpl. rewrite one_value. lra.
Qed.
Lemma times_facts facts q l : hold facts -> 0 <= Q2R q -> 0 <= eval (fold_right (times_fact facts)
  (Num q) l).
Proof.
  intros h hq. induction l as [|[i k] l IH]; [exact hq|]. simpl. apply Rmult_le_pos; trivial.
  apply pow_le. eapply has_sign_le. now apply hold_nth.
Qed.
Lemma nonnegative_value facts s : hold facts -> nonnegative_summand s = true ->
  0 <= eval (summand_value facts s).
Proof.
  destruct s as [[q squares] l]. intros h hq. unfold nonnegative_summand in hq. cbn [fst] in hq.
  apply Qle_bool_iff, Qle_Rle in hq. rewrite zero_value in hq. simpl.
  induction squares as [|t squares IH]; simpl.
  - now apply times_facts.
  - apply Rmult_le_pos; trivial. rewrite Rmult_1_r. apply Rle_0_sqr.
Qed.
Lemma positive_value facts s : hold facts -> positive_summand facts s = true ->
  0 < eval (summand_value facts s).
Proof.
  destruct s as [[q squares] l]. intros h hp. unfold positive_summand in hp.
  apply andb_prop in hp. destruct hp as [hp h3]. apply andb_prop in hp. destruct hp as [h1 h2].
  destruct squares; try discriminate. simpl.
  assert (hq : 0 < Q2R q).
  { rewrite <- zero_value. apply Qlt_Rlt, Qnot_le_lt. intro e. apply Qle_bool_iff in e.
    now rewrite e in h1. }
  induction l as [|[i k] l IH]; [exact hq|]. simpl in h3. apply andb_prop in h3.
    destruct h3 as [h3 h4].
  simpl. apply Rmult_lt_0_compat; [|now apply IH].
  unfold positive_factor in h3. cbn [fst snd] in h3. pose proof (hold_nth facts i h) as hs.
  destruct (snd (nth i facts (Num 1, true))).
  - now apply pow_lt.
  - apply Nat.eqb_eq in h3. rewrite h3. simpl. lra.
Qed.
Lemma proves_correct facts p e strict : hold facts -> proves facts p e strict = true ->
  has_sign (eval e) strict.
Proof.
  intros h hp. unfold proves in hp. apply andb_prop in hp. destruct hp as [hp h3].
    apply andb_prop in hp.
  destruct hp as [h1 h2].
  destruct (combination smoothness n (snd p) differences) as [s|] eqn:C; try discriminate.
  apply (vanishes_correct Phi (assignment sigma) K known_facts) in h3. rewrite normal_value in h3.
  cbn [Expressions.eval] in h3. rewrite (combination_zero _ _ C) in h3.
  set (total := eval (fold_right (fun s e => Plus (summand_value facts s) e) (Num 0) (fst p)))
    in h3.
  assert (E : eval e = total) by lra. rewrite E. unfold total. clear C h3 E total.
  assert (N : forall l, forallb nonnegative_summand l = true ->
    0 <= eval (fold_right (fun s e => Plus (summand_value facts s) e) (Num 0) l)).
  { induction l as [|t l IH]; intro hl; [simpl; rewrite zero_value; lra|]. simpl in hl.
    apply andb_prop in hl.
    destruct hl as [l1 l2]. pose proof (nonnegative_value facts t h l1). simpl.
      specialize (IH l2). lra. }
  destruct strict; [|now apply N]. simpl in h2. simpl.
  revert h1 h2. induction (fst p) as [|t l IH]; intros h1 h2; [discriminate|]. simpl in h1, h2.
  apply andb_prop in h1. destruct h1 as [l1 l2]. simpl. apply orb_prop in h2.
    destruct h2 as [h2|h2].
  - pose proof (positive_value facts t h h2). pose proof (N l l2). lra.
  - pose proof (nonnegative_value facts t h l1). specialize (IH l2 h2). lra.
Qed.
Lemma hold_last facts e s : hold facts -> has_sign (eval e) s -> hold (facts ++ [(e, s)]).
Proof. intros h hs. apply Forall_app. split; trivial. now constructor. Qed.
Theorem check_log_correct l : forall facts goal strict, hold facts ->
  check_log facts goal strict l = true ->
  has_sign (eval goal) strict.
Proof.
  induction l as [p|e s p rest IH|g a IHa b IHb]; intros facts goal strict h c; simpl in c.
  - eapply proves_correct; eassumption.
  - apply andb_prop in c. destruct c as [c1 c2]. eapply IH; [|exact c2]. apply hold_last; trivial.
    eapply proves_correct; eassumption.
  - apply andb_prop in c. destruct c as [c1 c2].
    destruct (Rle_dec 0 (eval (data smoothness n g))) as [d|d].
    + eapply IHa; [|exact c1]. now apply hold_last.
    + eapply IHb; [|exact c2]. apply hold_last; trivial. simpl. lra.
Qed.
End Check.

(* The values of the facts that are known. *)
Fixpoint fact_values (smoothness : list (nat * nat)) (n : nat) (K : list (ex * ex))
  (l : list (term * bool)) :
  option (list (ex * bool)) :=
  match l with
  | [] => Some []
  | (t, s) :: l' => match known_value smoothness n K t, fact_values smoothness n K l' with
      | Some e, Some m => Some ((e, s) :: m) | _, _ => None end
  end.
Definition check_sign smoothness n hypotheses nonzero reasons facts goal strict l : bool :=
  let K := knowledge smoothness n hypotheses nonzero reasons in
  match fact_values smoothness n K facts, known_value smoothness n K goal with
  | Some f, Some g =>
      check_log smoothness n K (map (known_difference smoothness n K) hypotheses) f g strict l
  | _, _ => false
  end.

Theorem sign Phi sigma smoothness n hypotheses nonzero reasons facts goal strict l :
  smooth_all smoothness Phi -> length sigma = n ->
  all_equal Phi sigma hypotheses -> all_nonzero Phi sigma nonzero -> all_signs Phi sigma facts ->
  check_sign smoothness n hypotheses nonzero reasons facts goal strict l = true ->
  if strict then 0 < denote Phi sigma goal else 0 <= denote Phi sigma goal.
Proof.
  intros hs hn he hz hf c. unfold check_sign in c. set (K := knowledge _ _ _ _ _) in c.
  assert (V : forall t e, known_value smoothness n K t = Some e ->
    denote Phi sigma t = eval Phi (assignment sigma) e)
    by (intros; eapply known_value_correct; eassumption).
  destruct (fact_values smoothness n K facts) as [f|] eqn:F; try discriminate.
  destruct (known_value smoothness n K goal) as [g|] eqn:G; try discriminate.
  change (has_sign (denote Phi sigma goal) strict). rewrite (V _ _ G).
  eapply check_log_correct; [| |clear c|exact c].
  - now apply knowledge_holds.
  - intros q s. eapply combination_vanishes; try eassumption. now apply known_differences_vanish.
  - revert f F. induction facts as [|[t s] facts IH]; intros f F; simpl in F.
    + injection F as <-. constructor.
    + destruct (known_value smoothness n K t) as [e|] eqn:E; try discriminate.
      destruct (fact_values smoothness n K facts) as [m|] eqn:M; try discriminate.
        injection F as <-.
      destruct hf as [h1 h2]. constructor; [|now apply IH]. simpl. rewrite <- (V _ _ E). exact h1.
Qed.
Corollary nonnegative Phi sigma smoothness n hypotheses nonzero reasons facts goal l :
  smooth_all smoothness Phi -> length sigma = n ->
  all_equal Phi sigma hypotheses -> all_nonzero Phi sigma nonzero -> all_signs Phi sigma facts ->
  check_sign smoothness n hypotheses nonzero reasons facts goal false l = true ->
    0 <= denote Phi sigma goal.
Proof. intros hs hn he hz hf c. exact (sign _ _ _ _ _ _ _ _ _ _ _ hs hn he hz hf c). Qed.
Corollary positive Phi sigma smoothness n hypotheses nonzero reasons facts goal l :
  smooth_all smoothness Phi -> length sigma = n ->
  all_equal Phi sigma hypotheses -> all_nonzero Phi sigma nonzero -> all_signs Phi sigma facts ->
  check_sign smoothness n hypotheses nonzero reasons facts goal true l = true ->
    0 < denote Phi sigma goal.
Proof. intros hs hn he hz hf c. exact (sign _ _ _ _ _ _ _ _ _ _ _ hs hn he hz hf c). Qed.
Arguments sign Phi sigma smoothness%nat n%nat.
Arguments nonnegative Phi sigma smoothness%nat n%nat.
Arguments positive Phi sigma smoothness%nat n%nat.
