// Tracks in bare numbers, as those who recorded crowds hand them out.
#include "agents/track_tables.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "agents/track_files.h"
#include "files/error.h"

namespace prairie {
namespace {

double median_speed_m_per_s(const std::vector<Track>& tracks) {
  std::vector<double> speeds;
  for (const Track& track : tracks) {
    for (std::size_t n = 1; n < track.times_s.size(); ++n)
      speeds.push_back(glm::distance(track.positions_m[n], track.positions_m[n - 1]) /
                       (track.times_s[n] - track.times_s[n - 1]));
  }
  std::ranges::sort(speeds);
  return speeds.at(speeds.size() / 2);
}

bool notes(const TrackFile& file, const std::string& part) {
  return std::ranges::any_of(file.notes,
                             [&](const auto& line) { return line.find(part) != std::string::npos; });
}

/// Three people at 1.4 m/s, `every` frames a row, as an obsmat with its velocities.
std::string obsmat(double frames_per_s, int every, double told_m_per_s) {
  std::string text;
  for (int n = 0; n < 20; ++n) {
    for (int id = 1; id <= 3; ++id)
      text += fmt::format("{} {} {} 0 {} {} 0 0\n", 780 + n * every, id, 1.4 * n * every / frames_per_s,
                          2 * id, told_m_per_s);
  }
  return text;
}

TEST(TrackTables, AnObsmatTellsItsFrameRateByItsVelocities) {
  const TrackFile eth = parse_tracks(obsmat(15.0, 6, 1.4), "obsmat.txt");
  EXPECT_NEAR(median_speed_m_per_s(eth.tracks), 1.4, 1e-6);
  EXPECT_TRUE(notes(eth, "15 frames a second"));
  const TrackFile ucy = parse_tracks(obsmat(25.0, 10, 1.4), "obsmat.txt");
  EXPECT_NEAR(median_speed_m_per_s(ucy.tracks), 1.4, 1e-6);
  EXPECT_TRUE(ucy.notes.empty());
  // Without velocities it is as UCY's are.
  EXPECT_NEAR(median_speed_m_per_s(parse_tracks(obsmat(25.0, 10, 0.0), "obsmat.txt").tracks), 1.4, 1e-6);
  EXPECT_NEAR(
      median_speed_m_per_s(parse_tracks(obsmat(15.0, 6, 1.4), "obsmat.txt", {.frames_per_s = 30.0}).tracks),
      2.8, 1e-6);
}

TEST(TrackTables, TrajNetWithEitherColumnFirst) {
  std::string frames_first, ids_first;
  for (int id = 0; id < 4; ++id) {
    for (int n = 0; n < 12; ++n) {
      const std::string place = fmt::format("{:.3f} {:.3f}\n", 0.5 * n + 7.0 * id, 3.0 * id);
      frames_first += fmt::format("{} {}.0 {}", 10 * n, id, place);
      ids_first += fmt::format("{}\t{}\t{}", id, 10 * n, place);
    }
  }
  for (const std::string& text : {frames_first, ids_first}) {
    const TrackFile file = parse_tracks(text, "biwi.txt");
    EXPECT_EQ(file.tracks.size(), 4u);
    EXPECT_NEAR(median_speed_m_per_s(file.tracks), 1.25, 1e-6);
    EXPECT_TRUE(notes(file, "TrajNet"));
  }
}

std::string juelich(double unit, double frames_per_s, double height) {
  std::string text;
  for (int id = 1; id <= 2; ++id) {
    for (int n = 0; n < 40; ++n)
      text += fmt::format("{} {} {:.4f} {:.4f} {:.2f}\n", id, n, unit * (1.0 + 1.3 * n / frames_per_s),
                          unit * id, unit * height);
  }
  return text;
}

TEST(TrackTables, JuelichInCentimetresAndInMetres) {
  for (const auto& [text, note] :
       {std::pair{juelich(100.0, 16.0, 1.75), "centimetres, 16 frames"},
        std::pair{juelich(1.0, 16.0, 1.75), "in metres, 16 frames"},
        std::pair{juelich(1.0, 25.0, 1.75), "in metres, 25 frames"},
        std::pair{"# framerate: 50.00 fps\n" + juelich(1.0, 50.0, 1.75), "in metres, 50 frames"},
        std::pair{"# id frame x/cm y/cm z/cm\n" + juelich(100.0, 16.0, 0.0), "centimetres"}}) {
    const TrackFile file = parse_tracks(text, "corridor.txt");
    EXPECT_EQ(file.tracks.size(), 2u);
    EXPECT_NEAR(median_speed_m_per_s(file.tracks), 1.3, 1e-3) << note;
    EXPECT_TRUE(notes(file, note)) << file.notes.at(0);
    EXPECT_NEAR(file.tracks[0].positions_m[0].x, 1.0, 1e-6);
  }
}

TEST(TrackTables, ARefusalNamesTheLayouts) {
  for (const char* text : {"1 2 3\n1 3 4\n", "1 2 3 4 5 6 7 8 9\n", "first second third\n1 2 3\n",
                           "frame;agent;px;py\n1;2;3;4\n"}) {
    try {
      parse_tracks(text, "tracks");
      ADD_FAILURE() << text;
    } catch (const BadInput& fault) {
      for (const char* layout : {"obsmat", "TrajNet", "Jülich", "CSV"})
        EXPECT_NE(fault.expected.find(layout), std::string::npos) << fault.what();
    }
  }
}

}  // namespace
}  // namespace prairie
