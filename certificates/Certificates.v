(* All that a certificate needs. *)
Require Export QArith_base.
Require Export PatchProof.Definitions PatchProof.Terms PatchProof.Jets PatchProof.Equations.
Require Export PatchProof.Refutations PatchProof.Signs PatchProof.Witnesses PatchProof.Facts.
Require Export PatchProof.Differentiated PatchProof.Elementary.
Require Export PatchProof.Scripts.
Open Scope R_scope.
