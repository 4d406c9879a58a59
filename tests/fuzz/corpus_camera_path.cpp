#include <string_view>

#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {

int replay_count() {
  return 30000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  for (const std::string_view text :
       {"time_s,x_m,y_m,z_m,yaw_deg,pitch_deg\n0,1,2,+1.7,350,0\n1,2,3,+2.5,10,-5\n4,5,5,+1,20,90\n",
        "fov_deg,time_s,y_m,x_m,z_m,yaw_deg,pitch_deg\r\n60,0,1,2,30,0,-10\r\n20,2.5,1,9,31,-720,-11\r\n"}) {
    corpus.emplace_back(text.begin(), text.end());
  }
  return corpus;
}

}  // namespace prairie::fuzz
