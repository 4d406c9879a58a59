// Public recordings, where PRAIRIE_DATA names the folder that holds them: a street seen from above, and three
// GPX files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>

#include "agents/track_files.h"
#include "agents/track_playback.h"
#include "files/error.h"

namespace prairie {
namespace {

class RecordedTracks : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("PRAIRIE_DATA");
    if (folder == nullptr) GTEST_SKIP() << "PRAIRIE_DATA is not set to the folder of recordings";
    zara_ = std::filesystem::path(folder) / "peds_ucy_zara/zara01/obsmat.txt";
    gpx_ = std::filesystem::path(folder) / "tracks_gpx";
    if (!std::filesystem::exists(zara_)) GTEST_SKIP() << "PRAIRIE_DATA holds no peds_ucy_zara";
    if (!std::filesystem::exists(gpx_)) GTEST_SKIP() << "PRAIRIE_DATA holds no tracks_gpx";
  }
  std::filesystem::path zara_, gpx_;
};

/// Played back it is finite everywhere, faces along its way, and is where its points are when they are.
void check_playback(const Track& track, double step_s) {
  const TrackPlayback playback(track);
  for (std::size_t n = 0; n < track.times_s.size(); ++n)
    ASSERT_EQ(playback.at(track.times_s[n]).position_m, track.positions_m[n]);
  for (double t = playback.first_s(); t <= playback.last_s(); t += step_s) {
    const TrackPlace place = playback.at(t);
    ASSERT_TRUE(place.present);
    ASSERT_TRUE(std::isfinite(place.position_m.x) && std::isfinite(place.position_m.y));
    ASSERT_NEAR(glm::length(place.forward), 1.0, 1e-12);
    if (place.speed_m_per_s > 1.001 * kStandingSpeedMPerS) {
      ASSERT_GT(glm::dot(place.forward, place.velocity_m_per_s), 0.999999 * place.speed_m_per_s);
    }
  }
}

double length_m(const std::vector<Track>& tracks) {
  double sum_m = 0.0;
  for (const Track& track : tracks) {
    for (std::size_t n = 1; n < track.positions_m.size(); ++n)
      sum_m += glm::distance(track.positions_m[n], track.positions_m[n - 1]);
  }
  return sum_m;
}

TEST_F(RecordedTracks, Zara01IsWalkedAsItWasRecorded) {
  const std::vector<Track> tracks = read_tracks(zara_, "replay").tracks;
  ASSERT_EQ(tracks.size(), 148u);
  std::map<std::int64_t, TrackPlayback> playbacks;
  for (const Track& track : tracks) playbacks.emplace(track.id, TrackPlayback(track));
  // Read once more, without the reader.
  std::ifstream file(zara_);
  double frame, id, x, z, y, v_x, v_z, v_y;
  double worst_m = 0.0;
  int rows = 0;
  while (file >> frame >> id >> x >> z >> y >> v_x >> v_z >> v_y) {
    const TrackPlace place = playbacks.at(static_cast<std::int64_t>(id)).at(frame / 25.0);
    ASSERT_TRUE(place.present);
    worst_m = std::max(worst_m, glm::distance(place.position_m, glm::dvec2(x, y)));
    ++rows;
  }
  EXPECT_EQ(rows, 5024);
  EXPECT_LT(worst_m, 1e-9);
}

TEST_F(RecordedTracks, Zara01FacesItsWay) {
  const std::vector<Track> tracks = read_tracks(zara_, "replay").tracks;
  double first_s = 1e9, last_s = 0.0, way_m = 0.0, walked_s = 0.0;
  for (const Track& track : tracks) {
    check_playback(track, 1.0 / 60.0);
    first_s = std::min(first_s, track.times_s.front());
    last_s = std::max(last_s, track.times_s.back());
    way_m += length_m({track});
    walked_s += track.times_s.back() - track.times_s.front();
  }
  EXPECT_DOUBLE_EQ(first_s, 0.04);
  EXPECT_DOUBLE_EQ(last_s, 9011.0 / 25.0);
  EXPECT_NEAR(way_m / walked_s, 1.11, 0.03);
}

TEST_F(RecordedTracks, Zara01InCentimetresIsRefused) {
  std::string text = "time_s,id,x_m,y_m\n";
  for (const Track& track : read_tracks(zara_, "replay").tracks) {
    for (std::size_t n = 0; n < track.times_s.size(); ++n) {
      const glm::dvec2 at_cm = 100.0 * track.positions_m[n];
      text += std::to_string(track.times_s[n]) + "," + std::to_string(track.id) + "," +
              std::to_string(at_cm.x) + "," + std::to_string(at_cm.y) + "\n";
    }
  }
  try {
    parse_tracks(text, "zara_cm.csv").tracks;
    ADD_FAILURE();
  } catch (const BadInput& fault) {
    EXPECT_NE(fault.expected.find("centimetres"), std::string::npos) << fault.what();
  }
}

TEST_F(RecordedTracks, GpxIsReadAndWalked) {
  struct Expected {
    const char* file;
    std::size_t points;
    double km;           // within segments, gaps aside, on a sphere
    glm::dvec2 start_m;  // easting and northing in zone 33 to some 100 m
  };
  const Expected files[] = {{"korita-zbevnica.gpx", 871, 14.82, {433000.0, 5025600.0}},
                            {"cerknicko-jezero.gpx", 296, 4.44, {450100.0, 5068900.0}},
                            {"around-visnjan-with-car.gpx", 104, 2.73, {399100.0, 5014100.0}}};
  for (const Expected& expected : files) {
    SCOPED_TRACE(expected.file);
    const std::vector<Track> tracks = read_tracks(gpx_ / expected.file, "replay").tracks;
    std::size_t points = 0;
    for (const Track& track : tracks) {
      points += track.times_s.size();
      check_playback(track, 1.0);
    }
    EXPECT_LE(points, expected.points);
    EXPECT_GE(points + 5, expected.points)
        << "points of a track without times that lie on one another are one";
    EXPECT_NEAR(length_m(tracks), 1000.0 * expected.km, 10.0 * expected.km);
    EXPECT_EQ(tracks.front().positions_m.front(), glm::dvec2(0.0));
    // The scene's origin only moves them.
    const UtmFrame scene{{33, true}, {400000.0, 5020000.0}};
    const std::vector<Track> there = read_tracks(gpx_ / expected.file, "replay", {.scene = scene}).tracks;
    ASSERT_EQ(there.size(), tracks.size());
    const glm::dvec2 by_m = there.front().positions_m.front();
    for (std::size_t n = 0; n < tracks.size(); ++n) {
      ASSERT_EQ(there[n].times_s.size(), tracks[n].times_s.size());
      for (std::size_t k = 0; k < tracks[n].positions_m.size(); ++k) {
        ASSERT_NEAR(there[n].times_s[k], tracks[n].times_s[k], 0.1) << "rounded to other millimetres";
        ASSERT_LT(glm::distance(there[n].positions_m[k], tracks[n].positions_m[k] + by_m), 0.003);
      }
    }
    EXPECT_LT(glm::distance(by_m, expected.start_m - scene.origin_m), 100.0);
  }
}

}  // namespace
}  // namespace prairie
