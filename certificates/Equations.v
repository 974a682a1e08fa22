(* Certificates of equations. *)
Require Import QArith Qreals Lia Lra.
Require Import PatchProof.Definitions PatchProof.Terms PatchProof.Polynomials
  PatchProof.Expressions.
Require Import PatchProof.Normal PatchProof.Jets PatchProof.Values PatchProof.Fractions
  PatchProof.Vanishing.
Local Open Scope R_scope.

(* The variables of a term stand for the places from 64 on;
  the places before are for bound variables. *)
Definition variables (n : nat) : list ex := map (fun k => At (Pos.of_succ_nat (63 + k))) (seq 0 n).
Definition assignment (sigma : list R) (p : positive) : R := nth (pred (Pos.to_nat p) - 63) sigma 0.
Lemma variables_value Phi sigma : map (eval Phi (assignment sigma)) (variables (length sigma))
  = sigma.
Proof.
  unfold variables. rewrite map_map. cbn [eval].
  apply nth_ext with 0 0; rewrite ?map_length, ?seq_length; trivial. intros k h.
  set (f := fun k => assignment sigma (Pos.of_succ_nat (63 + k))).
  rewrite (nth_indep _ 0 (f 0%nat)) by now rewrite map_length, seq_length.
  rewrite map_nth, seq_nth by exact h. unfold f, assignment. rewrite SuccNat2Pos.id_succ. f_equal.
    cbn [pred]. lia.
Qed.

(* Hypotheses of a certificate. *)
Fixpoint all_equal (Phi : list (list R -> R)) (sigma : list R) (l : list (term * term)) : Prop :=
  match l with
  | [] => True
  | (a, b) :: l' => denote Phi sigma a = denote Phi sigma b /\ all_equal Phi sigma l'
  end.
Fixpoint all_nonzero (Phi : list (list R -> R)) (sigma : list R) (l : list term) : Prop :=
  match l with
  | [] => True
  | a :: l' => denote Phi sigma a <> 0 /\ all_nonzero Phi sigma l'
  end.

(* A reason for a polynomial d to be different from 0: m d is the product of the terms with these
  numbers in
   the list of the terms different from 0, up to cofactors times the hypotheses. *)
Definition reason : Type := term * list nat * list term.
Definition Reason (m : term) (numbers : list nat) (cofactors : list term) : reason :=
  (m, numbers, cofactors).

Section Check.
Variable smoothness : list (nat * nat).
Variable n : nat.                              (* the number of variables *)
Variable hypotheses : list (term * term).
Variable nonzero_terms : list term.

Definition evaluated (t : term) : result :=
  match value smoothness 1 (variables n) t with Some (e, c) => Some (normal e,
    c) | None => None end.
(* Any expression will do for data that need no proof. *)
Definition data (t : term) : ex := match evaluated t with Some (e, _) => e | None => Num 0 end.
(* A hypothesis, respectively a term different from 0, that needs no condition;
  else a trivial one. *)
Definition plain_difference (h : term * term) : ex :=
  match evaluated (fst h), evaluated (snd h) with
  | Some (a, []), Some (b, []) => Minus a b
  | _, _ => Num 0
  end.
Definition plain_nonzero (t : term) : ex := match evaluated t with Some (e,
  []) => e | _ => Num 1 end.
Fixpoint weighted_sum (cofactors differences : list ex) : ex :=
  match cofactors, differences with
  | Num (0 # _) :: l, _ :: m => weighted_sum l m
  | q :: l, d :: m => Plus (Times q d) (weighted_sum l m)
  | _, _ => Num 0
  end.
Definition fact (differences nonzeros : list ex) (r : reason) : ex * ex :=
  let '(m, l, q) := r in
  (data m, Plus (fold_right (fun i p => Times (nth i nonzeros (Num 1)) p) (Num 1) l)
                (weighted_sum (map data q) differences)).
Definition knowledge (reasons : list reason) : list (ex * ex) :=
  let nonzeros := map plain_nonzero nonzero_terms in
  map (fun e => (Num 1, e)) nonzeros ++
  match reasons with
  | [] => []
  | _ => map (fact (map plain_difference hypotheses) nonzeros) reasons
  end.

(* The value of a term all of whose conditions are known. *)
Definition known_value (K : list (ex * ex)) (t : term) : option ex :=
  match evaluated t with
  | Some (e, c) => if forallb (fun d => never_zero K (normal d)) c then Some e else None
  | None => None
  end.
(* The difference of the sides of a hypothesis. *)
Definition known_difference (K : list (ex * ex)) (h : term * term) : option ex :=
  match known_value K (fst h), known_value K (snd h) with
  | Some x, Some y => Some (normal (Minus x y))
  | _, _ => None
  end.
(* The sum of the cofactors times the differences; what is not needed may be unknown. *)
Fixpoint combination (cofactors : list term) (differences : list (option ex)) : option ex :=
  match cofactors, differences with
  | q :: cofactors', d :: differences' =>
      match combination cofactors' differences', data q, d with
      | None, _, _ => None
      | Some s, Num (0 # _), _ => Some s
      | Some s, e, Some x => Some (Plus (Times e x) s)
      | Some _, _, None => None
      end
  | _, _ => Some (Num 0)
  end.
(* Goals: cofactors, and the two sides. *)
Definition remainder (K : list (ex * ex)) (differences : list (option ex))
  (goal : list term * (term * term)) : option ex :=
  let '(cofactors, (l, r)) := goal in
  match known_value K l, known_value K r, combination cofactors differences with
  | Some x, Some y, Some s => Some (normal (Minus (Minus x y) s))
  | _, _, _ => None
  end.
Definition check_equations (reasons : list reason) (goals : list (list term * (term * term)))
  : bool :=
  let K := knowledge reasons in
  let differences := map (known_difference K) hypotheses in
  forallb (fun g => match remainder K differences g with Some e => vanishes K e | None => false end)
    goals.
Definition check_equation (reasons : list reason) (cofactors : list term) (l r : term) : bool :=
  check_equations reasons [(cofactors, (l, r))].
(* For a certificate that fails: what is left of l - r, and whether each of its divisors is known
  not to be 0. *)
Definition residue (reasons : list reason) (cofactors : list term) (l r : term)
  : option (ex * list bool) :=
  let K := knowledge reasons in
  match remainder K (map (known_difference K) hypotheses) (cofactors, (l, r)) with
  | Some e => let T := table_for K e in Some (e, map (shown_nonzero T K) (divisors T e))
  | None => None
  end.
Definition check_nonzero (reasons : list reason) (t : term) : bool :=
  let K := knowledge reasons in match known_value K t with Some e => never_zero K e | None => false
    end.

Variable Phi : list (list R -> R).
Variable sigma : list R.
Hypothesis smooth_functions : smooth_all smoothness Phi.
Hypothesis number : length sigma = n.
Hypothesis equations : all_equal Phi sigma hypotheses.
Hypothesis different : all_nonzero Phi sigma nonzero_terms.
Notation eval := (eval Phi (assignment sigma)).
Notation denote := (denote Phi sigma).

Lemma evaluated_value t e c : evaluated t = Some (e, c) -> Forall (fun d => eval d <> 0) c ->
  denote t = eval e.
Proof.
  unfold evaluated. destruct (value smoothness 1 (variables n) t) as [[x d]|] eqn:E;
    try discriminate.
  intros [= <- <-] h. rewrite normal_value, <- (value_correct _ _ smooth_functions t _ _ _ _ _ E
    h), <- number.
  now rewrite variables_value.
Qed.
Lemma plain_differences_vanish : Forall (fun d => eval d = 0) (map plain_difference hypotheses).
Proof.
  rewrite Forall_map. induction hypotheses as [|[a b] l IH]; constructor.
  - destruct equations as [h _]. unfold plain_difference. cbn [fst snd].
    destruct (evaluated a) as [[x [|? ?]]|] eqn:A; try exact zero_value.
    destruct (evaluated b) as [[y [|? ?]]|] eqn:B; try exact zero_value.
    cbn [Expressions.eval]. rewrite <- (evaluated_value _ _ _ A), <- (evaluated_value _ _ _ B),
      h by constructor. ring.
  - apply IH. apply equations.
Qed.
Lemma plain_nonzero_values : Forall (fun d => eval d <> 0) (map plain_nonzero nonzero_terms).
Proof.
  assert (one : eval (Num 1) <> 0) by (cbn [Expressions.eval]; rewrite one_value; apply R1_neq_R0).
  rewrite Forall_map. induction nonzero_terms as [|a l IH]; constructor.
  - destruct different as [h _]. unfold plain_nonzero. destruct (evaluated a)
      as [[x [|? ?]]|] eqn:A; trivial.
    rewrite <- (evaluated_value _ _ _ A) by constructor. exact h.
  - apply IH. apply different.
Qed.
Lemma weighted_sum_vanishes q : forall d, Forall (fun d => eval d = 0) d ->
  eval (weighted_sum q d) = 0.
Proof.
  induction q as [|a q IH]; intros [|x d] h; try (now destruct a); try exact zero_value.
  - simpl. destruct a as [[[| |] ?]| | | | | | | | |]; exact zero_value.
  - inversion h; subst.
    assert (A : eval (Plus (Times a x) (weighted_sum q d)) = 0) by (cbn [Expressions.eval];
      rewrite IH, H1 by trivial; ring).
    simpl weighted_sum. destruct a as [[[| |] ?]| | | | | | | | |]; trivial. now apply IH.
Qed.
Lemma knowledge_holds reasons : Forall (fun f => eval (snd f) <> 0) (knowledge reasons).
Proof.
  unfold knowledge. apply Forall_app. pose proof plain_nonzero_values as z. split.
  - rewrite Forall_map. revert z. now apply Forall_impl.
  - destruct reasons as [|r0 reasons]; [constructor|]. rewrite Forall_map.
    rewrite Forall_forall. intros [[m l] q] _. cbn [fact snd Expressions.eval].
    rewrite weighted_sum_vanishes, Rplus_0_r by apply plain_differences_vanish.
    assert (one : eval (Num 1) <> 0) by (cbn [Expressions.eval]; rewrite one_value;
      apply R1_neq_R0).
    induction l as [|i l IH]; [exact one|]. cbn [fold_right Expressions.eval].
    apply Rmult_integral_contrapositive_currified; trivial.
    destruct (Nat.ltb_spec i (length (map plain_nonzero nonzero_terms))) as [h|h].
    + rewrite Forall_forall in z. apply z. now apply nth_In.
    + rewrite nth_overflow by exact h. exact one.
Qed.
Lemma known_value_correct reasons t e : known_value (knowledge reasons) t = Some e ->
  denote t = eval e.
Proof.
  unfold known_value. destruct (evaluated t) as [[x c]|] eqn:E; try discriminate.
  destruct (forallb _ c) eqn:F; try discriminate. intros [= <-]. apply (evaluated_value _ _ _ E).
  rewrite Forall_forall. rewrite forallb_forall in F. intros d i. rewrite <- normal_value.
  eapply never_zero_correct; [apply knowledge_holds|]. now apply F.
Qed.
Lemma known_differences_vanish reasons : forall l, all_equal Phi sigma l ->
  Forall (fun d => forall e, d = Some e -> eval e = 0)
    (map (known_difference (knowledge reasons)) l).
Proof.
  induction l as [|[a b] l IH]; intros h; [constructor|]. destruct h as [h h'].
  cbn [map]. constructor; [|now apply IH]. unfold known_difference. cbn [fst snd].
  destruct (known_value _ a) as [x|] eqn:X; try discriminate.
  destruct (known_value _ b) as [y|] eqn:Y; try discriminate. intros e [= <-].
  rewrite normal_value. cbn [Expressions.eval].
  rewrite <- (known_value_correct _ _ _ X), <- (known_value_correct _ _ _ Y), h. ring.
Qed.
Lemma combination_vanishes q : forall d s,
  Forall (fun d => forall e, d = Some e -> eval e = 0) d -> combination q d = Some s -> eval s = 0.
Proof.
  induction q as [|a q IH]; intros [|x d] s h E; simpl in E; try (injection E as <-;
    exact zero_value).
  inversion h; subst. destruct (combination q d) as [s'|] eqn:C; try discriminate.
  specialize (IH _ _ H2 C).
  assert (A : forall e, match x with Some x => Some (Plus (Times e x) s') | None => None end
    = Some s -> eval s = 0).
  { intros e. destruct x as [x|]; try discriminate. intros [= <-]. cbn [Expressions.eval].
    rewrite IH, (H1 x) by trivial. ring. }
  destruct (data a) as [[[| |] ?]| | | | | | | | |]; try (now apply A in E). now injection E as <-.
Qed.

Theorem equations_correct reasons goals :
  check_equations reasons goals = true -> all_equal Phi sigma (map snd goals).
Proof.
  unfold check_equations. set (K := knowledge reasons). set (D := map _ hypotheses).
  assert (V : Forall (fun d => forall e, d = Some e -> eval e = 0) D)
    by now apply known_differences_vanish.
  induction goals as [|[q [l r]] goals IH]; [easy|]. cbn [forallb map snd all_equal].
  rewrite andb_true_iff. intros [h h']. split; [|now apply IH]. revert h. unfold remainder.
  destruct (known_value K l) as [x|] eqn:X; try discriminate.
  destruct (known_value K r) as [y|] eqn:Y; try discriminate.
  destruct (combination q D) as [s|] eqn:E; try discriminate. intro h.
  apply (vanishes_correct Phi (assignment sigma) K (knowledge_holds reasons)) in h.
    rewrite normal_value in h.
  cbn [Expressions.eval] in h. rewrite (combination_vanishes _ _ _ V E) in h.
  rewrite (known_value_correct _ _ _ X), (known_value_correct _ _ _ Y). lra.
Qed.
Theorem nonzero_correct reasons t : check_nonzero reasons t = true -> denote t <> 0.
Proof.
  unfold check_nonzero.
  destruct (known_value (knowledge reasons) t) as [e|] eqn:E; try discriminate.
  rewrite (known_value_correct _ _ _ E). apply never_zero_correct. apply knowledge_holds.
Qed.
End Check.

(* The sides of every goal are equal for all values of the unknown functions and of the variables
  for which the hypotheses hold. *)
Theorem equations Phi sigma smoothness n hypotheses nonzero reasons goals :
  smooth_all smoothness Phi -> length sigma = n ->
  all_equal Phi sigma hypotheses -> all_nonzero Phi sigma nonzero ->
  check_equations smoothness n hypotheses nonzero reasons goals = true ->
  all_equal Phi sigma (map snd goals).
Proof. intros. eapply equations_correct; eassumption. Qed.
Arguments equations Phi sigma smoothness%nat n%nat.

(* The same for one goal. *)
Theorem equation Phi sigma smoothness n hypotheses nonzero reasons cofactors l r :
  smooth_all smoothness Phi -> length sigma = n ->
  all_equal Phi sigma hypotheses -> all_nonzero Phi sigma nonzero ->
  check_equation smoothness n hypotheses nonzero reasons cofactors l r = true ->
  denote Phi sigma l = denote Phi sigma r.
Proof. intros. now apply (equations Phi sigma smoothness n hypotheses nonzero reasons
  [(cofactors, (l, r))]). Qed.
Arguments equation Phi sigma smoothness%nat n%nat.

(* t is different from 0. *)
Theorem never_zero_term Phi sigma smoothness n hypotheses nonzero reasons t :
  smooth_all smoothness Phi -> length sigma = n ->
  all_equal Phi sigma hypotheses -> all_nonzero Phi sigma nonzero ->
  check_nonzero smoothness n hypotheses nonzero reasons t = true -> denote Phi sigma t <> 0.
Proof. intros. eapply nonzero_correct; eassumption. Qed.
Arguments never_zero_term Phi sigma smoothness%nat n%nat.
