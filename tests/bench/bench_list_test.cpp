// The list of measurements that `prairie bench` chooses from.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "bench/bench.h"

namespace prairie {
namespace {

TEST(BenchListTest, NoNameStandsTwice) {
  const std::vector<std::string> names = bench_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(BenchListTest, APrefixChoosesTheNamesThatBeginWithIt) {
  EXPECT_EQ(chosen_bench_names("planting"),
            (std::vector<std::string>{"planting.cpu_blades_per_s_core", "planting.gpu_ns_per_blade"}));
  EXPECT_EQ(chosen_bench_names("scale.repeat10_r"), std::vector<std::string>{"scale.repeat10_ratio"});
  EXPECT_EQ(chosen_bench_names("picture.scale").size(), 3u);
  EXPECT_TRUE(chosen_bench_names("plantings").empty());
  EXPECT_TRUE(run_benches("plantings", {}).empty());
}

TEST(BenchListTest, WithoutPrefixAllButTheLongOnesAreChosen) {
  const std::vector<std::string> chosen = chosen_bench_names("");
  EXPECT_EQ(std::ranges::count(chosen, "scale.frame_ms_median"), 1);
  EXPECT_EQ(std::ranges::count(chosen, "picture.scale_flip"), 0);
}

}  // namespace
}  // namespace prairie
