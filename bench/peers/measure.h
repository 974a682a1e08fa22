// Timing that all peers written in C and C++ share.
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

// Whether the claim of this size holds; the mutant is false and goes the same way.
typedef int (*Proof)(int n, int mutant);

static double cpu_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int compare_times(const void* a, const void* b) {
  const double x = *(const double*)a;
  const double y = *(const double*)b;
  return (x > y) - (x < y);
}

// Prints "true NANOSECONDS VERDICT" and "mutant NANOSECONDS VERDICT": the median of at least three
// runs, and of as many as fit into the seconds given. A run that takes long is not repeated.
static void measure(Proof proof, int n, double seconds) {
  enum { most = 1001 };
  static double times[most];
  for (int mutant = 0; mutant < 2; ++mutant) {
    double total = 0;
    int runs = 0;
    int verdict = 0;
    while (runs < most && (runs < 3 ? total < 5 * seconds : total < seconds)) {
      const double begin = cpu_now();
      const int answer = proof(n, mutant);
      times[runs] = cpu_now() - begin;
      total += times[runs++];
      // One answer that differs from the others would be a wrong one.
      if (runs > 1 && answer != verdict) exit(70);
      verdict = answer;
    }
    qsort(times, (size_t)runs, sizeof *times, compare_times);
    printf("%s %.0f %d\n", mutant ? "mutant" : "true", 1e9 * times[runs / 2], verdict);
    fflush(stdout);
  }
}

struct Workload {
  const char* name;
  Proof proof;
};

// The main program of a peer: WORKLOAD N SECONDS.
static int measure_named(const struct Workload* all, int argc, char** argv) {
  if (argc == 4)
    for (; all->name != NULL; ++all)
      if (strcmp(all->name, argv[1]) == 0) {
        measure(all->proof, atoi(argv[2]), atof(argv[3]));
        return 0;
      }
  fprintf(stderr, "usage: %s WORKLOAD N SECONDS\n", argv[0]);
  return 64;
}
