// Prints the hash of the meadow that every build has to agree on (tests/generator/hash_matrix.sh).
#include <cinttypes>
#include <cstdio>

#include "tests/generator/hashed_meadow.h"

int main() {
  std::printf("%016" PRIx64 "\n", prairie::hashed_meadow_hash());
  return 0;
}
