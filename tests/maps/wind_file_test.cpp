#include "maps/wind_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "files/error.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

TEST(WindFile, HoldsASampleALine) {
  const WindFile wind = parse_wind_file(
      "\xef\xbb\xbftime_s, speed_m_per_s,gusts,heading_rad\r\n0,5.5,x,0.25\r\n0.1,6,,-3\r\n\r\n", "wind.csv");
  ASSERT_EQ(wind.times_s.size(), 2u);
  EXPECT_EQ(wind.times_s[1], 0.1);
  EXPECT_EQ(wind.speeds_m_per_s[0], 5.5);
  EXPECT_EQ(wind.headings_rad[1], -3.0);
}

TEST(WindFile, KnowsWhereWeatherComesFrom) {
  const WindFile wind =
      parse_wind_file("speed_m_per_s,direction_deg,time_s\n1,0,1\n1,90,2\n1,225,3", "wind.csv");
  ASSERT_EQ(wind.times_s.size(), 3u);
  // From north to south, from east to west, from south-west to north-east.
  EXPECT_NEAR(std::sin(wind.headings_rad[0]), -1.0, 1e-12);
  EXPECT_NEAR(std::cos(wind.headings_rad[1]), -1.0, 1e-12);
  EXPECT_NEAR(wind.headings_rad[2], 0.7853981633974483, 1e-12);
}

TEST(WindFile, NamesLineAndColumnOfWhatIsWrong) {
  const auto refused = [](const std::string& rows, const std::string& field, const std::string& found) {
    try {
      parse_wind_file("time_s,speed_m_per_s,heading_rad\n" + rows, "wind.csv");
      ADD_FAILURE() << rows << " was accepted";
    } catch (const BadInput& fault) {
      EXPECT_EQ(fault.file, "wind.csv");
      EXPECT_EQ(fault.field, field);
      EXPECT_EQ(fault.found, found);
    }
  };
  refused("0,5,0\n1,,0\n", "line 3: speed_m_per_s", "nothing");
  refused("0,5,0\n1,calm,0\n", "line 3: speed_m_per_s", "\"calm\"");
  refused("0,5,0\n1,nan,0\n", "line 3: speed_m_per_s", "\"nan\"");
  refused("0,5,0\n1,-2,0\n", "line 3: speed_m_per_s", "\"-2\"");
  refused("0,5,0\n1,5,1e9\n", "line 3: heading_rad", "\"1e9\"");
  refused("0,5,0\n0,5,0\n", "line 3: time_s", "\"0\"");
  refused("2,5,0\n1,5,0\n", "line 3: time_s", "\"1\"");
  refused("0,5,0\n\n1,5,0\n", "line 3", "1 values");
  refused("0,5,0\n1,5\n", "line 3", "2 values");
  refused("0,5,0\n1,5,0,7\n", "line 3", "4 values");
  refused("", "", "no sample");
  EXPECT_THROW(parse_wind_file("", "wind.csv"), BadInput);
  EXPECT_THROW(parse_wind_file("time_s,speed_m_per_s\n0,5\n", "wind.csv"), BadInput);
  EXPECT_THROW(parse_wind_file(std::string(1000, '\0'), "wind.csv"), BadInput);
}

TEST(WindFile, IsReadFromDisk) {
  const TemporaryFolder folder;
  testing::write_text(folder / "wind.csv", "time_s,speed_m_per_s,heading_rad\n0,5,0\n");
  EXPECT_EQ(read_wind_file(folder / "wind.csv").times_s.size(), 1u);
  EXPECT_THROW(read_wind_file(folder / "other.csv"), BadInput);
}

}  // namespace
}  // namespace prairie
