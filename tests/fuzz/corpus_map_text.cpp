#include <string_view>

#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {

int replay_count() {
  return 20000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  for (const std::string_view text :
       {"0.5\n0\n0\n-0.5\n702000.25\n4333999.75\n", "1 0 0 -1 0 0", "-9999", "-3.4028234663852886e+38", "nan",
        "inf", "+1e-400", "1e400", " \t\r\n"}) {
    corpus.emplace_back(text.begin(), text.end());
  }
  return corpus;
}

}  // namespace prairie::fuzz
