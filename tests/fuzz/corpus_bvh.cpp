#include <string>

#include "tests/agents/walking_bvh.h"
#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {

int replay_count() {
  return 20000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  BvhNames nameless = walking_bvh_names();
  nameless["LeftLeg"] = "b";
  for (const std::string& text : {walking_bvh(walking_bvh_names(), 120), walking_bvh(walking_bvh_names(), 9),
                                  walking_bvh(walking_bvh_names(), 90, 0.0), walking_bvh(nameless, 20)}) {
    corpus.emplace_back(text.begin(), text.end());
  }
  return corpus;
}

}  // namespace prairie::fuzz
