#include <string_view>

#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {

int replay_count() {
  return 30000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  for (const std::string_view text :
       {"time_s,speed_m_per_s,direction_deg\n0.0,4.1,265\n0.1,4.4,262\n1e1,0,-90\n",
        "gust,heading_rad,time_s,speed_m_per_s\r\n,1.5,-2,3\r\nx,-3.25,7,99.9\r\n"}) {
    corpus.emplace_back(text.begin(), text.end());
  }
  return corpus;
}

}  // namespace prairie::fuzz
