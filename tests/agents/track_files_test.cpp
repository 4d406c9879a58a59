#include "agents/track_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "agents/track_playback.h"
#include "files/error.h"

namespace prairie {
namespace {

const std::string kHead = "time_s,id,x_m,y_m\n";

BadInput fault_of(const std::string& text, const std::optional<UtmFrame>& scene = std::nullopt) {
  try {
    parse_tracks(text, "tracks", {.scene = scene}).tracks;
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, "tracks");
    EXPECT_FALSE(fault.found.empty());
    EXPECT_FALSE(fault.expected.empty());
    return fault;
  }
  ADD_FAILURE() << "taken: " << text.substr(0, 200);
  return BadInput("", "", "", "");
}

/// Two walkers, whose rows alternate, in metres times `scale`.
std::string two_walkers(double scale, double gap_s = 0.5) {
  std::string text = kHead;
  for (int n = 0; n < 20; ++n) {
    const double t = gap_s * n;
    text += fmt::format("{},7,{},2\n{},-3,{},{}\n", t, scale * 1.3 * t, t, scale * t, -scale * t);
  }
  return text;
}

std::string gpx_of(const std::string& segments) {
  return "<gpx version=\"1.0\"><trk>\n" + segments + "</trk></gpx>\n";
}

TEST(TrackFiles, ReadsCsv) {
  const std::vector<Track> tracks = parse_tracks(two_walkers(1.0), "tracks").tracks;
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, -3);
  EXPECT_EQ(tracks[1].id, 7);
  ASSERT_EQ(tracks[1].times_s.size(), 20u);
  EXPECT_EQ(tracks[1].times_s[19], 9.5);
  EXPECT_EQ(tracks[1].positions_m[19], glm::dvec2(1.3 * 9.5, 2.0));
}

TEST(TrackFiles, ReadsWhatTheProgramWrites) {
  const std::vector<Track> tracks =
      parse_tracks(
          "time_s,id,x_m,y_m,z_m,heading_rad,speed_m_per_s,d_m,theta_rad,left_planted,right_planted\r\n"
          "0.000,4,1.5,2.5,0.1,0.2,1.3,0,0,1,0\r\n0.017,4,1.52,2.5,0.1,0.2,1.3,nan,,1,0\r\n\r\n",
          "tracks")
          .tracks;
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].times_s, (std::vector<double>{0.0, 0.017}));
  EXPECT_EQ(tracks[0].positions_m[1], glm::dvec2(1.52, 2.5));
}

TEST(TrackFiles, ColumnsMayComeInAnyOrder) {
  const std::vector<Track> tracks =
      parse_tracks("\xef\xbb\xbfy_m, id ,\"x_m\",time_s\n4,1,3,0.5\n", "tracks").tracks;
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[0].positions_m[0], glm::dvec2(3.0, 4.0));
}

TEST(TrackFiles, ReadsUcy) {
  const std::vector<Track> tracks =
      parse_tracks(
          "   1.0000e+00   1.0e+00  -2.829260e+00   0.0e+00   1.895935e+01   0.0  0.0  -1.32\n"
          "\n   1.1000e+01   1.0e+00  -2.829260e+00   0.0e+00   1.843074e+01   0.0  0.0  -1.32\r\n"
          "11\t2\t0\t0\t1\t0\t0\t0",
          "obsmat.txt")
          .tracks;
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].times_s, (std::vector<double>{0.04, 0.44}));
  EXPECT_EQ(tracks[0].positions_m[1], glm::dvec2(-2.82926, 18.43074));
  EXPECT_EQ(tracks[1].id, 2);
}

TEST(TrackFiles, ALongGapSplitsATrack) {
  const std::vector<Track> tracks =
      parse_tracks(kHead + "0,1,0,0\n1,1,1,0\n6,1,2,0\n11.1,1,3,0\n12,1,4,0\n", "tracks").tracks;
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, tracks[1].id);
  EXPECT_EQ(tracks[0].times_s, (std::vector<double>{0.0, 1.0, 6.0})) << "5 s are no gap";
  EXPECT_EQ(tracks[1].times_s, (std::vector<double>{11.1, 12.0}));
}

TEST(TrackFiles, RefusesTimesThatDoNotRise) {
  const BadInput reversed = fault_of(kHead + "0,1,0,0\n0.5,2,0,0\n1,1,1,0\n0.75,1,2,0\n");
  EXPECT_EQ(reversed.field, "line 5: time");
  EXPECT_EQ(reversed.found, "0.75 s after 1 s (line 4) for id 1");
  EXPECT_EQ(fault_of(kHead + "0,1,0,0\n0,1,1,0\n").field, "line 3: time");
  EXPECT_EQ(fault_of("11 1 0 0 0 0 0 0\n1 1 0 0 0 0 0 0\n").field, "line 2: time");
}

TEST(TrackFiles, RefusesCentimetres) {
  const BadInput fault = fault_of(two_walkers(100.0));
  EXPECT_NE(fault.expected.find("centimetres"), std::string::npos);
  EXPECT_NE(fault.found.find("m/s"), std::string::npos);
  EXPECT_EQ(parse_tracks(two_walkers(5.0), "tracks").tracks.size(), 2u);
}

TEST(TrackFiles, RefusesTimesInMilliseconds) {
  EXPECT_NE(fault_of(two_walkers(1.0, 400.0)).found.find("400 s or more"), std::string::npos);
}

TEST(TrackFiles, RefusesTextAndNumbersThatAreNone) {
  EXPECT_EQ(fault_of(kHead + "0,1,0,0\n1,1,here,0\n").field, "line 3: x_m");
  EXPECT_EQ(fault_of(kHead + "0,1,0,nan\n").field, "line 2: y_m");
  EXPECT_EQ(fault_of(kHead + "inf,1,0,0\n").field, "line 2: time_s");
  EXPECT_EQ(fault_of(kHead + "0,1.5,0,0\n").field, "line 2: id");
  EXPECT_EQ(fault_of(kHead + "0,1e300,0,0\n").field, "line 2: id");
  EXPECT_EQ(fault_of(kHead + "0,1,0\n").field, "line 2");
  EXPECT_EQ(fault_of("time_s,id,x_m,z_m\n0,1,0,0\n").field, "line 1");
  EXPECT_EQ(fault_of("1 1 0 0 zero 0 0 0\n").field, "line 1");
  EXPECT_EQ(fault_of("1 1 0 0 0 0 0 0\n2 1 0 0 nan 0 0 0\n").field, "line 2: column 5");
  EXPECT_EQ(fault_of("1 1.5 0 0 0 0 0 0\n").field, "line 1: id (column 2)");
  EXPECT_EQ(fault_of("1 1 0 0 0 0 0 0 0\n").field, "line 1");
  for (const char* text :
       {"", "\n\n", "Dear all,\nhello\n", "hello", "<html></html>", "<gpx></gpx>", "\xef\xbb\xbf"})
    fault_of(text);
}

TEST(TrackFiles, RefusesNoRows) {
  EXPECT_EQ(fault_of(kHead).found, "no row");
  EXPECT_EQ(fault_of(kHead + "\n\n").found, "no row");
  EXPECT_EQ(fault_of(gpx_of("<trkseg/>")).found, "no point of a track");
}

TEST(TrackFiles, PlacesGpxByItsFirstPointOrByTheScene) {
  const std::string text = gpx_of(
      "<trkseg></trkseg><trkseg>\n"
      "<trkpt lat=\"45.3806\" lon=\"14.1445\"><time>2010-10-03T09:36:30Z</time></trkpt>\n"
      "<trkpt lat=\"45.3807\" lon=\"14.1445\"><time>2010-10-03T09:36:40Z</time></trkpt>\n"
      "<trkpt lat=\"45.3807\" lon=\"14.1446\"><time>2010-10-03T09:36:45Z</time></trkpt></trkseg>\n");
  const std::vector<Track> alone = parse_tracks(text, "walk.gpx").tracks;
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].id, 1);
  EXPECT_EQ(alone[0].times_s, (std::vector<double>{0.0, 10.0, 15.0}));
  EXPECT_EQ(alone[0].positions_m[0], glm::dvec2(0.0));
  EXPECT_NEAR(glm::length(alone[0].positions_m[1]), 11.114, 0.01);
  EXPECT_GT(alone[0].positions_m[1].y, 11.0);
  EXPECT_NEAR(glm::distance(alone[0].positions_m[1], alone[0].positions_m[2]), 7.83, 0.01);
  const UtmFrame scene{{33, true}, {432000.0, 5025000.0}};
  const std::vector<Track> there = parse_tracks(text, "walk.gpx", {.scene = scene}).tracks;
  const glm::dvec2 first_m = utm_m(scene.zone, {45.3806, 14.1445}) - scene.origin_m;
  for (int n = 0; n < 3; ++n)
    EXPECT_LT(glm::distance(there[0].positions_m[n], first_m + alone[0].positions_m[n]), 0.002);
  EXPECT_EQ(fault_of(text, UtmFrame{{14, true}, {}}).field, "line 3: lon");
}

TEST(TrackFiles, WalksGpxWithoutTimes) {
  const std::vector<Track> tracks =
      parse_tracks(gpx_of("<trkseg><trkpt lat=\"45\" lon=\"15\"/><trkpt lat=\"45\" lon=\"15\"/><trkpt "
                          "lat=\"45.001\" lon=\"15\"/>"
                          "<trkpt lat=\"45.001\" lon=\"15.004\"/></trkseg>"),
                   "walk.gpx")
          .tracks;
  ASSERT_EQ(tracks.size(), 1u);
  const Track& track = tracks[0];
  ASSERT_EQ(track.times_s.size(), 3u) << "the same place twice is one, and a long way is no gap";
  EXPECT_EQ(track.times_s[0], 0.0);
  for (std::size_t n = 1; n < 3; ++n) {
    EXPECT_NEAR(glm::distance(track.positions_m[n], track.positions_m[n - 1]),
                kGpxSpeedMPerS * (track.times_s[n] - track.times_s[n - 1]), 1e-9);
  }
}

TEST(TrackFiles, RefusesGpxThatCannotBePlacedInTime) {
  const auto point = [](const std::string& time) {
    return "<trkpt lat=\"45\" lon=\"15\">" + (time.empty() ? "" : "<time>" + time + "</time>") + "</trkpt>\n";
  };
  const std::string noon = point("2010-10-03T12:00:00Z");
  EXPECT_EQ(fault_of(gpx_of("<trkseg>\n" + noon + point("") + "</trkseg>")).field, "line 4");
  EXPECT_EQ(fault_of(gpx_of("<trkseg>\n" + point("") + noon + "</trkseg>")).field, "line 4");
  EXPECT_EQ(fault_of(gpx_of("<trkseg>\n<trkpt lat=\"89\" lon=\"15\"/></trkseg>")).field, "line 3: lat");
}

TEST(TrackFiles, LeavesOutPointsOfClocksThatStandStillOrAreSetBack) {
  const auto point = [](int second, double lon) {
    return fmt::format("<trkpt lat=\"45\" lon=\"{}\"><time>2010-10-03T12:00:{:02}Z</time></trkpt>\n", lon,
                       second);
  };
  std::string text;
  // Five fixes a second told in whole seconds once, then three seconds back.
  for (const int second : {0, 1, 2, 2, 3, 4, 5, 3, 4, 5, 6, 7}) text += point(second, 15.0 + 1e-5 * second);
  const TrackFile file = parse_tracks(gpx_of("<trkseg>\n" + text + "</trkseg>"), "walk.gpx");
  ASSERT_EQ(file.tracks.size(), 1u);
  EXPECT_EQ(file.tracks[0].times_s, (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_TRUE(file.notes[0].starts_with("4 points left out")) << file.notes[0];
}

TEST(TrackFiles, TakesWhatSpreadsheetsWrite) {
  for (const char* text :
       {"time_s;id;x_m;y_m\n0.5;1;1.25;2\n1;1;2;2\n", "time_s;id;x_m;y_m\n0,5;1;1,25;2\n1;1;2;2\n",
        "time_s\tid\tx_m\ty_m\n0.5\t1\t1.25\t2\n1\t1\t2\t2\n"}) {
    const std::vector<Track> tracks = parse_tracks(text, "tracks").tracks;
    ASSERT_EQ(tracks.size(), 1u);
    EXPECT_EQ(tracks[0].times_s[0], 0.5);
    EXPECT_EQ(tracks[0].positions_m[0].x, 1.25);
  }
}

TEST(TrackFiles, ReadsAndRefusesFiles) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "prairie_track_files_test.csv";
  EXPECT_THROW(read_tracks("/no/such/file", "replay").tracks, BadInput);
  std::ofstream(file) << two_walkers(1.0);
  EXPECT_EQ(read_tracks(file, "replay").tracks.size(), 2u);
  std::ofstream(file).close();
  try {
    read_tracks(file, "replay").tracks;
    ADD_FAILURE();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.field, "replay");
    EXPECT_EQ(fault.found, "an empty file");
  }
  std::filesystem::remove(file);
}

TEST(TrackFiles, ManyWalkersAreRead) {
  std::string text = kHead;
  constexpr int kWalkers = 100'000;
  for (int n = 0; n < kWalkers; ++n) text += fmt::format("0,{},{},0\n", (n * 7919) % kWalkers, n % 1000);
  const std::vector<Track> tracks = parse_tracks(text, "tracks").tracks;
  ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kWalkers));
  for (int n = 0; n < kWalkers; ++n) ASSERT_EQ(tracks[n].id, n);
}

TEST(TrackFilesLongTest, AMillionWalkersArePlayedBack) {
  std::string text = kHead;
  constexpr int kWalkers = 1'000'000;
  for (int frame = 0; frame < 2; ++frame) {
    for (int n = 0; n < kWalkers; ++n) text += fmt::format("{},{},{},{}\n", frame, n, n % 1000, frame);
  }
  std::vector<Track> tracks = parse_tracks(text, "tracks").tracks;
  ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kWalkers));
  for (Track& track : tracks) ASSERT_EQ(TrackPlayback(std::move(track)).at(0.5).position_m.y, 0.5);
}

TEST(TrackFilesLongTest, TooManyRowsAreRefused) {
  std::string text = kHead;
  for (std::size_t n = 0; n <= kMostTrackRows; ++n) text += fmt::format("0,{},0,0\n", n);
  EXPECT_EQ(fault_of(text).found, "more than 4000000 rows");
}

}  // namespace
}  // namespace prairie
