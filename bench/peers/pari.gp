\\ W1, W2, W3 with PARI's polynomials; the claims are linear in the points, the k-th of which is X^k.
\\ Set before: workload, n, seconds.
\\ The first variable that is named is the main one. This order is the fastest.
X; U; W; a; b; c; d;
bern(n, t) = my(p = powers(t, n), q = powers(1 - t, n)); vector(n + 1, i, binomial(n, i-1)*p[i]*q[n+2-i]);
\\ The control points are given, so they are no part of the proof.
V = matrix(n + 1, n + 1, i, j, X^if(j == 1, i, if(j == n + 1, n + 1 + i, 2*n + 1 + j + if(i == n + 1, n - 1, 0))));
blend(s, t, c1, c2, d1, d2, p, q, r, z) = c1 + t*(c2 - c1) + d1 + s*(d2 - d1) - (p + s*(q - p) + t*(r + s*(z - r) - p - s*(q - p)));
coons(n, s, t) =
{
  my(bs = bern(n, s), bt = bern(n, t));
  blend(s, t, sum(i = 0, n, bs[i+1]*V[i+1,1]), sum(i = 0, n, bs[i+1]*V[i+1,n+1]),
    sum(j = 0, n, bt[j+1]*V[1,j+1]), sum(j = 0, n, bt[j+1]*V[n+1,j+1]),
    V[1,1], V[n+1,1], V[1,n+1], V[n+1,n+1]);
}
\\ n*n times a point of the discrete Coons net; one factor of the mutant is wrong.
net(n, i, j, mutant) =
{
  n*(n-j)*V[i+1,1] + n*j*V[i+1,n+1] + n*(n-i)*V[1,j+1] + n*i*V[n+1,j+1]
  - (n-i)*(n-j)*V[1,1] - i*(n-j)*V[n+1,1] - (n-i)*j*V[1,n+1] - i*j*V[n+1,n+1]
  + if(i == 1 && j == 1, mutant)*V[1,2];
}
W1(n, mutant) =
{
  my(bu = bern(n, U), bv = bern(n, W));
  n^2*coons(n, U, W) == sum(i = 0, n, bu[i+1]*sum(j = 0, n, bv[j+1]*net(n, i, j, mutant)));
}
W2(n, mutant) =
{
  my(p = coons(n, U, W) + mutant*U^2*W^2*V[1,2]);
  deriv(deriv(deriv(deriv(p, U), U), W), W) == 0;
}
\\ The mutant takes one corner from the wrong place.
W3(n, mutant) =
{
  my(s = a + U*(b - a), t = c + W*(d - c));
  coons(n, s, t) == blend(U, W, coons(n, s, c), coons(n, s, d), coons(n, a, t), coons(n, b, t),
    coons(n, a, c), coons(n, b, c), coons(n, a, d), coons(n, if(mutant, a, b), d));
}
\\ The clock has milliseconds, so short proofs are timed by the batch.
proof = [W1, W2, W3][workload];
{
  for(mutant = 0, 1,
    my(times = List(), total = 0, verdict, batch = 1, time);
    gettime();
    verdict = proof(n, mutant);
    time = gettime();
    if(time < 20, batch = 50; for(k = 1, batch, proof(n, mutant)); time = gettime(); batch = 1 + batch*20\(time + 1));
    while(if(#times < 3, total < 5000*seconds, total < 1000*seconds),
      for(k = 1, batch, if(proof(n, mutant) != verdict, quit(70)));
      time = gettime();
      total += time;
      listput(times, time/batch));
    times = vecsort(Vec(times));
    print(if(mutant, "mutant ", "true "), round(10^6*times[#times\2 + 1]), " ", verdict));
}
quit
