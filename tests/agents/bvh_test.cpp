#include "agents/bvh.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

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
  EXPECT_EQ(gait_refusal(walking_bvh(names, 200)), "joints|no left knee, no right wrist");
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
  EXPECT_EQ(gait_refusal(walking_bvh(walking_bvh_names(), 200, 0.0)),
            "motion|hips that hardly leave their place");
}

}  // namespace
}  // namespace prairie
