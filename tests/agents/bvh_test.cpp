#include "agents/bvh.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <sstream>
#include <vector>

#include "agents/gait_of_bvh.h"
#include "files/error.h"
#include "tests/agents/walking_bvh.h"

namespace prairie {
namespace {

constexpr std::string_view kTwoBones =
    "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
    "Yrotation\n"
    " JOINT left arm\n {\n  OFFSET 1 0 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n"
    "  End Site\n  {\n   OFFSET 2 0 0\n  }\n }\n}\n"
    "MOTION\nFrames: 2\nFrame Time: 0.05\n0 0 0 0 0 0 0 0 0\n1 2 3 90 0 0 0 90 0\n";

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const std::size_t at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return result.replace(at, from.size(), to);
}

/// "FIELD|FOUND|EXPECTED" of what is thrown.
std::string refusal(std::string_view text) {
  try {
    parse_bvh(text, "walk.bvh");
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.file, "walk.bvh");
    return bad.field + "|" + bad.found + "|" + bad.expected;
  }
  return "nothing";
}

TEST(Bvh, ReadsJointsChannelsAndFrames) {
  const BvhMotion motion = parse_bvh(kTwoBones, "walk.bvh");
  ASSERT_EQ(motion.joints.size(), 3u);
  EXPECT_EQ(motion.joints[1].name, "left arm");
  EXPECT_EQ(motion.joints[1].parent, 0);
  EXPECT_EQ(motion.joints[1].first_value, 6u);
  EXPECT_TRUE(motion.joints[2].name.empty());
  EXPECT_EQ(motion.frame_count(), 2u);
  EXPECT_EQ(motion.frame_s, 0.05);
}

TEST(Bvh, PlacesJointsThroughTheirParents) {
  const BvhMotion motion = parse_bvh(kTwoBones, "walk.bvh");
  std::vector<glm::dvec3> places(3);
  place_joints(motion, 1, places);
  EXPECT_LT(glm::distance(places[1], glm::dvec3(1.0, 3.0, 3.0)), 1e-5);
  EXPECT_LT(glm::distance(places[2], glm::dvec3(1.0, 5.0, 3.0)), 1e-5);
}

TEST(Bvh, SaysInWhichLineItIsWrong) {
  EXPECT_EQ(refusal(""), "line 1|the end of the file|\"HIERARCHY\"");
  EXPECT_EQ(refusal(replaced(kTwoBones, "OFFSET 1 0 0", "OFFSET 1 x 0")),
            "line 8|\"x\"|a number, at most 1000000 in magnitude");
  EXPECT_EQ(refusal(replaced(kTwoBones, "OFFSET 1 0 0", "OFFSET 1 nan 0")),
            "line 8|\"nan\"|a number, at most 1000000 in magnitude");
  EXPECT_EQ(refusal(replaced(kTwoBones, "CHANNELS 3 Zrotation", "CHANNELS 3 Wrotation")),
            "line 9|\"Wrotation\"|a channel such as Xposition or Zrotation");
  EXPECT_EQ(refusal(replaced(kTwoBones, "CHANNELS 3", "CHANNELS 7")), "line 9|\"7\"|a whole number, 0 to 6");
  EXPECT_EQ(refusal(replaced(kTwoBones, "Frames: 2", "Frames: 1.5")),
            "line 17|\"1.5\"|a whole number, 1 to 200000");
  EXPECT_EQ(refusal(replaced(kTwoBones, "Frames: 2", "Frames: 199999")),
            "line 18|\"Frames:\"|as many values as 199999 frames need");
  EXPECT_EQ(refusal(replaced(kTwoBones, "Frames: 2", "Frames: 3")),
            "line 21|the end of the file|a number, at most 1000000 in magnitude");
  EXPECT_EQ(refusal(replaced(kTwoBones, "Frames: 2", "Frames: 1")),
            "line 20|\"1\"|the end of the file after 1 frames");
  EXPECT_EQ(refusal(replaced(kTwoBones, "Time: 0.05", "Time: 0")),
            "line 18|\"0\"|a frame time, 0.0001 to 1 s");
  EXPECT_NE(refusal(replaced(kTwoBones, " JOINT left arm", " JOINT ")), "nothing");
}

TEST(Bvh, DepthAndNumberOfJointsAreBounded) {
  std::string deep = "HIERARCHY ROOT a\n{\n";
  for (int n = 0; n < 100'000; ++n) deep += "JOINT b\n{\n";
  EXPECT_NE(refusal(deep).find("at most 1000 joints"), std::string::npos);
}

TEST(Bvh, JointsWithoutChannelsCostNoMemoryWithoutBound) {
  std::string many = "HIERARCHY ROOT a\n{\nCHANNELS 1 Xrotation\n";
  for (int n = 0; n < 900; ++n) many += "JOINT b\n{\n}\n";
  many += "}\nMOTION\nFrames: 150000\nFrame Time: 0.01\n";
  for (int n = 0; n < 150'000; ++n) many += "0\n";
  EXPECT_NE(refusal(many).find("at most 22197 frames of 901 joints"), std::string::npos) << refusal(many);
}

TEST(Bvh, EveryBeginningOfAFileIsRefused) {
  const std::string walk = walking_bvh(walking_bvh_names(), 40);
  for (std::size_t length = 0; length < walk.rfind(' '); length += 7)
    EXPECT_NE(refusal(std::string_view(walk).substr(0, length)), "nothing") << length;
}

std::string gait_refusal(const std::string& text) {
  try {
    gait_of(parse_bvh(text, "walk.bvh"));
  } catch (const BadInput& bad) {
    return bad.field + "|" + bad.found;
  }
  return "nothing";
}

TEST(GaitOfBvh, NamesTheJointsThatAreMissing) {
  BvhNames names = walking_bvh_names();
  names["LeftLeg"] = "Bone 7";
  names["RightHand"] = "Bone 8";
  const std::string refused = gait_refusal(walking_bvh(names, 200));
  EXPECT_TRUE(refused.starts_with("joints|no left knee, no right wrist, among Hips, Neck, LeftUpLeg, Bone 7"))
      << refused;
}

TEST(GaitOfBvh, KnowsJointsByOtherNames) {
  const Gait gait = gait_of(parse_bvh(walking_bvh(walking_bvh_names(), 200), "walk.bvh"));
  BvhNames mixamo;
  for (const auto& [name, shown] : walking_bvh_names()) mixamo[name] = "mixamorig:" + name;
  EXPECT_EQ(gait_of(parse_bvh(walking_bvh(mixamo, 200), "walk.bvh")).keys, gait.keys);
  BvhNames others = walking_bvh_names();
  others["LeftUpLeg"] = "thigh.L";
  others["LeftLeg"] = "shin.L";
  others["RightFoot"] = "R_Ankle";
  others["RightForeArm"] = "rForearm";
  EXPECT_EQ(gait_of(parse_bvh(walking_bvh(others, 200), "walk.bvh")).keys, gait.keys);
}

TEST(GaitOfBvh, MeasuresAWalkOfKnownTiming) {
  const Gait gait = gait_of(parse_bvh(walking_bvh(walking_bvh_names(), 200), "walk.bvh"));
  EXPECT_NEAR(gait.period_s, 1.0, 0.02);
  EXPECT_NEAR(gait.speed_m_per_s, 1.2, 0.05);
}

TEST(GaitOfBvh, RefusesWhatIsNoWalk) {
  EXPECT_EQ(gait_refusal(walking_bvh(walking_bvh_names(), 5)).substr(0, 7), "motion|");
  EXPECT_EQ(gait_refusal(walking_bvh(walking_bvh_names(), 40)).substr(0, 7), "motion|");
  // Who stands still walks neither on the spot nor anywhere.
  std::string still = walking_bvh(walking_bvh_names(), 200, 0.0);
  const std::size_t motion = still.find("Frame Time");
  const std::size_t first = still.find('\n', motion) + 1;
  const std::string frame = still.substr(first, still.find('\n', first) + 1 - first);
  still.resize(first);
  for (int n = 0; n < 200; ++n) still += frame;
  EXPECT_TRUE(gait_refusal(still).ends_with("nobody walks")) << gait_refusal(still);
}

/// The same walk with its root's six values changed frame by frame.
std::string with_root(const std::string& walk, const std::function<std::array<double, 6>(int frame)>& root) {
  std::istringstream in(walk);
  std::string text;
  int frame = -1;
  for (std::string line; std::getline(in, line);) {
    if (frame >= 0) {
      std::istringstream numbers(line);
      std::string value, rest;
      for (int n = 0; numbers >> value; ++n) rest += n < 6 ? "" : " " + value;
      line = fmt::format("{:.6f}", fmt::join(root(frame), " ")) + rest;
      ++frame;
    }
    if (line.starts_with("Frame Time")) frame = 0;
    text += line + "\n";
  }
  return text;
}

constexpr double kFrameS = 0.02;

void expect_same_walk(const std::string& text, double tolerance) {
  const Gait straight = gait_of(parse_bvh(walking_bvh(walking_bvh_names(), 300), "walk.bvh"));
  const Gait gait = gait_of(parse_bvh(text, "walk.bvh"));
  EXPECT_NEAR(gait.speed_m_per_s, straight.speed_m_per_s, 2.0 * tolerance);
  EXPECT_NEAR(gait.period_s, straight.period_s, tolerance);
  EXPECT_NEAR(gait.stance, straight.stance, tolerance);
  for (const GaitCurve curve : {GaitCurve::kArmSwing, GaitCurve::kSolePitch, GaitCurve::kPelvisRise}) {
    for (std::size_t key = 0; key < kGaitKeyCount; ++key)
      EXPECT_NEAR(gait.keys[static_cast<std::size_t>(curve)][key],
                  straight.keys[static_cast<std::size_t>(curve)][key], 2.0 * tolerance);
  }
}

TEST(GaitOfBvh, TakesWalksOnTheSpot) {
  expect_same_walk(walking_bvh(walking_bvh_names(), 300, 0.0), 0.06);
}

TEST(GaitOfBvh, TakesWalksInCurves) {
  // Once round a circle of 1.2 m/s · 6 s, to the left; BVH's yaw turns from Z to X.
  const double turn_rad_per_s = 2.0 * 3.14159265358979 / 6.0, radius_cm = 120.0 / turn_rad_per_s;
  const auto round = [&](int frame) {
    const double angle = turn_rad_per_s * kFrameS * frame;
    return std::array<double, 6>{radius_cm * (1.0 - std::cos(angle)), 92.0, radius_cm * std::sin(angle), 0.0,
                                 angle * 180.0 / 3.14159265358979,    0.0};
  };
  expect_same_walk(with_root(walking_bvh(walking_bvh_names(), 300), round), 0.08);
}

/// A file of the same walk with another axis up.
std::string turned_over(const std::string& walk,
                        const std::function<std::array<double, 3>(double, double, double)>& turn,
                        const std::string& rotation_channel) {
  std::istringstream in(walk);
  std::string text;
  bool moves = false;
  for (std::string line; std::getline(in, line);) {
    double x = 0.0, y = 0.0, z = 0.0;
    if (std::sscanf(line.c_str(), " OFFSET %lf %lf %lf", &x, &y, &z) == 3) {
      line = fmt::format("OFFSET {:.6f}", fmt::join(turn(x, y, z), " "));
    } else if (line == "CHANNELS 1 Xrotation") {
      line = "CHANNELS 1 " + rotation_channel;
    } else if (moves) {
      std::istringstream numbers(line);
      numbers >> x >> y >> z;
      std::string rest;
      std::getline(numbers, rest);
      line = fmt::format("{:.6f}", fmt::join(turn(x, y, z), " ")) + rest;
    }
    moves = moves || line.starts_with("Frame Time");
    text += line + "\n";
  }
  return text;
}

TEST(GaitOfBvh, FindsWhichAxisIsUp) {
  const std::string walk = walking_bvh(walking_bvh_names(), 300);
  const auto z_up = [](double x, double y, double z) { return std::array<double, 3>{x, -z, y}; };
  const auto x_up = [](double x, double y, double z) { return std::array<double, 3>{y, z, x}; };
  expect_same_walk(turned_over(walk, z_up, "Xrotation"), 1e-3);
  expect_same_walk(turned_over(walk, x_up, "Zrotation"), 1e-3);
}

TEST(GaitOfBvh, KnowsTheNamesOfManyTools) {
  const Gait gait = gait_of(parse_bvh(walking_bvh(walking_bvh_names(), 200), "walk.bvh"));
  const std::vector<std::string> parts{"UpLeg", "Leg", "Foot", "ToeBase", "Arm", "ForeArm", "Hand"};
  struct Tool {
    std::string format;  // of side and part
    std::array<std::string, 2> sides;
    std::vector<std::string> parts;
    std::string neck;
  };
  const std::vector<std::string> biped{"Thigh", "Calf", "Foot", "Toe0", "UpperArm", "Forearm", "Hand"};
  const std::vector<Tool> tools{
      {"mixamorig_{0}{1}", {"Left", "Right"}, parts, "mixamorig_Neck"},
      {"mixamorig1:{0}{1}", {"Left", "Right"}, parts, "mixamorig1:Neck"},
      {"Bip01 {0} {1}", {"L", "R"}, biped, "Bip01 Neck"},
      {"Bip001_{0}_{1}", {"L", "R"}, biped, "Bip001_Neck"},
      {"CC_Base_{0}_{1}",
       {"L", "R"},
       {"Thigh", "Calf", "Foot", "ToeBase", "Upperarm", "Forearm", "Hand"},
       "CC_Base_Neck"},
      {"DEF-{1}.{0}",
       {"L", "R"},
       {"thigh", "shin", "foot", "toe", "upper_arm", "forearm", "hand"},
       "DEF-neck"},
      {"{1}.{0}",
       {"L", "R"},
       {"upper_leg", "lower_leg", "foot", "toes", "upper_arm", "lower_arm", "hand"},
       "head"},
      {"J_Bip_{0}_{1}",
       {"L", "R"},
       {"UpperLeg", "LowerLeg", "Foot", "ToeBase", "UpperArm", "LowerArm", "Hand"},
       "J_Bip_C_Neck"},
      {"{0}_{1}", {"L", "R"}, {"Hip", "Knee", "Ankle", "Foot", "Shoulder", "Elbow", "Wrist"}, "Neck"},
      {"{0}_{1}", {"left", "right"}, {"hip", "knee", "ankle", "foot", "shoulder", "elbow", "wrist"}, "neck"},
      {"{0}{1}", {"l", "r"}, {"thigh", "shin", "foot", "toe", "uparm", "forearm", "hand"}, "neck"},
      {"{1}{0}", {"l", "r"}, {"thigh", "shin", "foot", "toe", "uparm", "forearm", "hand"}, "neck"},
  };
  for (const Tool& tool : tools) {
    BvhNames names;
    names["Neck"] = tool.neck;
    for (std::size_t side : {0, 1}) {
      for (std::size_t n = 0; n < parts.size(); ++n)
        names[(side == 0 ? "Left" : "Right") + parts[n]] =
            fmt::format(fmt::runtime(tool.format), tool.sides[side], tool.parts[n]);
    }
    SCOPED_TRACE(names["LeftUpLeg"]);
    ASSERT_EQ(gait_refusal(walking_bvh(names, 200)), "nothing");
    EXPECT_EQ(gait_of(parse_bvh(walking_bvh(names, 200), "walk.bvh")).keys, gait.keys);
  }
}

}  // namespace
}  // namespace prairie
