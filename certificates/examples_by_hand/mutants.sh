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
mutant coons 's/Smooth 1 2; Smooth 1 2\]/Smooth 1 2; Smooth 1 3]/'                        # more smoothness than given
mutant coons 's/Smooth 1 2; Smooth 1 2\]/Smooth 1 2; Smooth 1 1]/'                        # too little smoothness
mutant coons 's/(Lam 1 (Int 1)) (Lam 1 (Int 0))/(Lam 1 (Int 0)) (Lam 1 (Int 0))/'         # the twin of the witness
mutant curves 's,1 / 4 \* b0 + 3 / 4 \* b1,1 / 4 * b0 + 1 / 2 * b1,'                     # a coefficient
mutant curves 's/Mul (Int 4) (Mul (Pow (Var 0) 2)/Mul (Int 2) (Mul (Pow (Var 0) 2)/'      # a cofactor
mutant curves 's/\[App WT \[Var 0\]\] \[\]/[] []/; s/(conj w I) _)/I _)/'                 # a denominator not known
mutant curves 's/Done (Sum \[Summand 1 \[\] \[Factor 2 2\]\] \[\]))$/Done (Sum [Summand 1 [] [Factor 2 1]] []))/'
mutant curves 's,t \* (1 - t) <= 1 / 4,t * (1 - t) <= 1 / 5,'
mutant curves 's/(Summand (4 # 3)/(Summand (-4 # 3)/; s/Summand (4 # 3)/Summand (1 # 3)/'
mutant curves 's/Factor 0 3\]\] \[\])/Factor 1 3]] [])/'
mutant curves 's,(b + 2 \* a) / 6,(b + 2 * a) / 3,'
rm -f mutant.v mutant.vo mutant.vok mutant.vos mutant.glob .mutant.aux
exit $failed
