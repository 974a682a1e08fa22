\\ W1 to W6 with PARI's polynomials; the claims are linear in the points, the k-th of which is X^k.
\\ Set before: workload, n, seconds, folder.
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
\\ W4: the Bézier points of a clamped uniform cubic; the mutant has one wrong factor.
lines(d, mutant) =
{
  my(n = #d, last = n - 3, b = vector(3*last + 1), begin, end, f, change);
  b[1] = d[1];
  b[3*last + 1] = d[n];
  for(k = 0, last - 1,
    begin = max(k - 1, 0);
    end = min(k + 2, last);
    change = d[k + 3] - d[k + 2];
    for(side = 1, 2,
      f = if(mutant && k == 1 && side == 1, 1/5, (k + side - 1 - begin)/(end - begin));
      b[3*k + side + 1] = d[k + 2] + f*change));
  for(k = 1, last - 1, b[3*k + 1] = (b[3*k] + b[3*k + 2])/2);
  b;
}
smooth(b) =
{
  forstep(k = 4, #b - 1, 3,
    my(left = b[k] - b[k-1], right = b[k+1] - b[k]);
    if(left != right || left - b[k-1] + b[k-2] != b[k+2] - b[k+1] - right, return(0)));
  1;
}
\\ A line of points is a vector of columns, so PARI works on whole columns.
turned(b) = my(m = matconcat(b)~); vector(#m, k, m[, k]);
given = if(workload == 4, vector(3, k, vector(n, i, vector(n, j, ((7*(i-1) + 13*(j-1) + 5*(k-1) + (i-1)*(j-1)) % 101 - 50)/(1 + (i - 1 + 2*(j-1) + 3*(k-1)) % 7))~)));
W4(n, mutant) =
{
  for(k = 1, 3,
    my(b = lines(given[k], mutant));
    b = lines(turned(b), 0);
    if(!smooth(b) || !smooth(turned(b)), return(0)));
  1;
}
\\ W5: the energy of a net C is the sum of G[i,k] G[j,l] <C[i,j], C[k,l]>, G being these integrals,
\\ here times a whole number; the Hessian is the Kronecker square of the inner part of G.
gram(n) =
{
  my(m = n - 1, common = lcm(vector(2*m + 1, k, binomial(2*m, k-1))), f);
  f = ((p, q) -> if(p < 0 || q < 0 || p > m || q > m, 0, common\binomial(2*m, p+q)*binomial(m, p)*binomial(m, q)));
  matrix(n + 1, n + 1, i, k, f(i-2, k-2) + f(i-1, k-1) - f(i-2, k-1) - f(i-1, k-2));
}
\\ By elimination without fractions: all leading minors are positive.
definite(m) =
{
  my(before = 1, size = #m);
  for(p = 1, size,
    if(m[p, p] <= 0, return(0));
    for(i = p + 1, size, my(f = m[i, p]); for(k = p, size, m[i, k] = (m[i, k]*m[p, p] - f*m[p, k])\before));
    before = m[p, p]);
  1;
}
W5(n, mutant) =
{
  my(g = gram(n), rows = g[2..n, ], c = matrix(n + 1, n + 1, i, j, net(n, i-1, j-1, mutant)));
  definite(g[2..n, 2..n]) && rows*c*rows~ == 0;
}
\\ W6: the Bernstein form of the Jacobian, subdivided, without fractions.
differences(n, a) = matrix(n, n + 1, i, j, (a[i+1, j] - a[i, j])*binomial(n-1, i-1)*binomial(n, j-1));
\\ A scaled Bernstein form multiplies like a polynomial.
inU(a) = my(d = differences(#a - 1, a)); sum(j = 1, #d, Pol(d[, j]~)*X^(j-1));
inV(a) = my(d = differences(#a - 1, a~)~); sum(j = 1, #d, Pol(d[, j]~)*X^(j-1));
halves(lines, side) =
{
  my(first = vector(side), second = vector(side));
  for(k = 1, side,
    first[k] = lines[1] << (side - k);
    second[side + 1 - k] = lines[#lines] << (side - k);
    lines = vector(#lines - 1, i, lines[i] + lines[i+1]));
  [first, second];
}
\\ A box is a vector of lines; it is turned before it is halved, so the directions change.
positive(box, side, depth) =
{
  my(m = matconcat(box), parts);
  if(vecmin(m) > 0, return(1));
  if(vecmin([m[1,1], m[1,side], m[side,1], m[side,side]]) <= 0 || depth == 40, return(0));
  m = m~;
  parts = halves(vector(side, k, m[, k]), side);
  positive(parts[1], side, depth + 1) && positive(parts[2], side, depth + 1);
}
nets = if(workload == 6, [readvec(Str(folder, "/W6_", n, "_true.gp"))[1], readvec(Str(folder, "/W6_", n, "_mutant.gp"))[1]]);
W6(n, mutant) =
{
  my(x = nets[mutant + 1][1], y = nets[mutant + 1][2], p = inU(x)*inV(y) - inU(y)*inV(x), side = 2*n);
  my(common = lcm(vector(side, i, binomial(side - 1, i-1))), w = vector(side, i, common\binomial(side - 1, i-1)));
  my(c = vector(side, j, my(q = polcoef(p, j-1, X)); vector(side, i, polcoef(q, side-i)*w[i]*w[j])~));
  positive(c, side, 0);
}
\\ The clock has milliseconds, so short proofs are timed by the batch.
proof = [W1, W2, W3, W4, W5, W6][workload];
{
  for(mutant = 0, 1,
    my(times = List(), total = 0, verdict, batch = 1, time);
    verdict = proof(n, mutant);
    while(1,
      gettime();
      for(k = 1, batch, proof(n, mutant));
      time = gettime();
      if(time >= 50, break);
      batch = if(time < 10, 5*batch, 1 + batch*65\time));
    while(if(#times < 3, total < 5000*seconds, total < 1000*seconds),
      for(k = 1, batch, if(proof(n, mutant) != verdict, quit(70)));
      time = gettime();
      total += time;
      listput(times, time/batch));
    times = vecsort(Vec(times));
    print(if(mutant, "mutant ", "true "), round(10^6*times[#times\2 + 1]), " ", verdict));
}
quit
