// Reads expressions, one a line; says for each whether it is zero.
#include <stdio.h>
#include <string.h>

#include <flint/fmpq_mpoly.h>

int main(void) {
  const char* names[] = {"u", "v", "a", "b", "c", "d"};
  fmpq_mpoly_ctx_t ring;
  fmpq_mpoly_t difference;
  fmpq_mpoly_ctx_init(ring, 6, ORD_LEX);
  fmpq_mpoly_init(difference, ring);
  static char line[1 << 16];
  while (fgets(line, sizeof line, stdin) != NULL) {
    line[strcspn(line, "\n")] = '\0';
    if (fmpq_mpoly_set_str_pretty(difference, line, names, ring) != 0) return 65;
    putchar(fmpq_mpoly_is_zero(difference, ring) ? '1' : '0');
  }
  putchar('\n');
  fmpq_mpoly_clear(difference, ring);
  fmpq_mpoly_ctx_clear(ring);
  return 0;
}
