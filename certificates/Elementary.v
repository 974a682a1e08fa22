(* Sine, cosine and the exponential function: a certificate has them as unknown functions,
  with these facts as
   hypotheses. *)
Require Import Lra FunctionalExtensionality.
Require Import PatchProof.Definitions.
Local Open Scope R_scope.

Theorem sine_derivative x : Derive sin x = cos x.
Proof. apply is_derive_unique, is_derive_Reals, derivable_pt_lim_sin. Qed.
Theorem cosine_derivative x : Derive cos x = - sin x.
Proof. apply is_derive_unique, is_derive_Reals, derivable_pt_lim_cos. Qed.
Theorem exponential_derivative x : Derive exp x = exp x.
Proof. apply is_derive_unique, is_derive_Reals, derivable_pt_lim_exp. Qed.
Theorem sine_cosine x : sin x * sin x + cos x * cos x = 1.
Proof. exact (sin2_cos2 x). Qed.
Theorem exponential_sum x y : exp (x + y) = exp x * exp y.
Proof. apply exp_plus. Qed.
Theorem exponential_positive x : 0 < exp x.
Proof. apply exp_pos. Qed.

Lemma wave_derivative a b x : is_derive (fun x => a * sin x + b * cos x)
  x (- b * sin x + a * cos x).
Proof.
  replace (- b * sin x + a * cos x) with (plus (scal a (cos x)) (scal b (- sin x))).
  - apply @is_derive_plus; apply is_derive_scal; apply is_derive_Reals;
      [apply derivable_pt_lim_sin|apply derivable_pt_lim_cos].
  - change (a * cos x + b * - sin x = - b * sin x + a * cos x). ring.
Qed.
Lemma wave_smooth n : forall a b, smooth n (fun x => a * sin x + b * cos x).
Proof.
  assert (D : forall k a b, exists a' b', Nat.iter k Derive (fun x => a * sin x + b * cos x)
    = (fun x => a' * sin x + b' * cos x)).
  { induction k as [|k IH]; intros a b; [now exists a, b|]. destruct (IH a b) as [a' [b' E]].
    exists (- b'), a'. simpl. rewrite E. apply functional_extensionality. intro x.
    apply is_derive_unique, wave_derivative. }
  intros a b k x _. destruct (D k a b) as [a' [b' ->]]. eexists. apply wave_derivative.
Qed.
Theorem sine_smooth n : smooth n sin.
Proof.
  replace sin with (fun x => 1 * sin x + 0 * cos x) by (apply functional_extensionality; intro;
    ring).
  apply wave_smooth.
Qed.
Theorem cosine_smooth n : smooth n cos.
Proof.
  replace cos with (fun x => 0 * sin x + 1 * cos x) by (apply functional_extensionality; intro;
    ring).
  apply wave_smooth.
Qed.
Theorem exponential_smooth n : smooth n exp.
Proof.
  assert (D : forall k, Nat.iter k Derive exp = exp).
  { induction k as [|k IH]; trivial. simpl. rewrite IH. apply functional_extensionality,
    exponential_derivative. }
  intros k x _. rewrite D. exists (exp x). apply is_derive_Reals, derivable_pt_lim_exp.
Qed.
