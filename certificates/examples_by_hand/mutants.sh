#!/bin/sh
# Every one of these changes of an example has to be rejected by coqc.  Run in this folder, after the library
# was compiled: one line per change, exit 1 if one passes.
failed=0
mutant() {  # file, sed expression
  sed "$2" "$1.v" > mutant.v
  if cmp -s "$1.v" mutant.v; then echo "no change: $1 $2"; failed=1
  elif coqc -q -w -ambiguous-paths -Q .. PatchProof mutant.v > /dev/null 2>&1; then echo "accepted: $1 $2"; failed=1
  else echo "rejected: $1 $2"; fi
}
mutant coons 's/Opp (Var 0); Int 0; Int 0\]/Var 0; Int 0; Int 0]/'                      # a cofactor
mutant coons 's/(curve 0 (Int 1), curve 3 (Int 0))/(curve 0 (Int 1), curve 3 (Int 1))/'   # a hypothesis of the twin
mutant coons 's/- ((1 - u) \* (1 - v) \* C1 0/+ ((1 - u) * (1 - v) * C1 0/'               # the statement
mutant coons 's/Smooth 1 2\]/Smooth 1 3]/'                        # more smoothness than given
mutant coons 's/smooth 2/smooth 1/g; s/Smooth 1 2/Smooth 1 1/g'                        # too little smoothness
mutant coons 's/(Lam 1 (Int 1)) (Lam 1 (Int 0))/(Lam 1 (Int 0)) (Lam 1 (Int 0))/'         # the twin of the witness
mutant curves 's,1 / 4 \* b0 + 3 / 4 \* b1,1 / 4 * b0 + 1 / 2 * b1,'                     # a coefficient
mutant curves 's/Mul (Int 4) (Mul (Pow (Var 0) 2)/Mul (Int 2) (Mul (Pow (Var 0) 2)/'      # a cofactor
mutant curves 's/\[App WT \[Var 0\]\] \[\]/[] []/; s/(conj w I) _)/I _)/'                 # a denominator not known
mutant curves 's/Done (Sum \[Summand 1 \[\] \[Factor 2 2\]\] \[\]))$/Done (Sum [Summand 1 [] [Factor 2 1]] []))/'
mutant curves 's,t \* (1 - t) <= 1 / 4,t * (1 - t) <= 1 / 5,'
mutant curves 's/(Summand (4 # 3)/(Summand (-4 # 3)/; s/Summand (4 # 3)/Summand (1 # 3)/'
mutant curves 's/Factor 0 3\]\] \[\])/Factor 1 3]] [])/'
mutant curves 's,(b + 2 \* a) / 6,(b + 2 * a) / 3,'
mutant derivatives 's/Derive f t \* w t - f t/Derive f t * w t + f t/'
mutant derivatives "s/(conj sf (conj sw I)) eq_refl I (conj z I) _)/(conj sf (conj sw I)) eq_refl I I _)/; s/\[App (Unknown 1) \[Var 0\]\] \[\] \[\]/[] [] []/"
mutant derivatives 's/2 \/ t ^ 3/- 2 \/ t ^ 3/'
mutant derivatives 's/smooth2 3 r/smooth2 2 r/; s/Smooth 2 3/Smooth 2 2/'              # too little smoothness
mutant derivatives 's/4 \* t \* D_v (D_u r)/2 * t * D_v (D_u r)/; s/(Int 4) (Var 0)/(Int 2) (Var 0)/'
mutant derivatives 's/D_1 (D_3 (D_2 r))/D_1 (D_3 (D_3 r))/; s/Deriv 0 (Deriv 2 (Deriv 1/Deriv 0 (Deriv 2 (Deriv 2/'
mutant derivatives 's/Derive (fun s => s) t ^ 2 = 2/Derive (fun s => s) t ^ 2 = 3/; s/(Int 2) (conj (sine_smooth/(Int 3) (conj (sine_smooth/'
mutant derivatives 's/(Mul (Var 0) (Var 1))/(Mul (Var 0) (Var 0))/; s/u \* v/u * u/; s/u \* v/u * u/'
mutant splines 's,(d2 + d3) / 2,(d2 + d3) / 3,; s,(Add (Var 2) (Var 3)) (Int 2),(Add (Var 2) (Var 3)) (Int 3),'
mutant splines 's/0; 0; 0; 0; 1; 1; 2/0; 0; 0; 0; 1; 3\/2; 2/'
mutant splines 's/h 0 1 0 0 0 0/h 0 0 0 0 0 0/; s/Int 0; Int 1; Int 0/Int 0; Int 0; Int 0/'
rm -f mutant.v mutant.vo mutant.vok mutant.vos mutant.glob .mutant.aux
exit $failed
