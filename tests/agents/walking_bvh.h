// A walk made for tests, as text of a BVH file: stiff legs that swing once a second, back in 0.6 s as the
// feet stand.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>

namespace prairie {

/// From the joint's name in this file to the name written.
using BvhNames = std::map<std::string, std::string>;

inline BvhNames walking_bvh_names() {
  BvhNames names;
  for (const char* name :
       {"Neck", "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase", "RightUpLeg", "RightLeg", "RightFoot",
        "RightToeBase", "LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm", "RightHand"}) {
    names[name] = name;
  }
  return names;
}

inline double swing_degrees(double time_s) {
  const double phase = time_s - std::floor(time_s), back = (phase - 0.6) / 0.4;
  return 24.7 * (phase < 0.6 ? 1.0 - phase / 0.3 : 2.0 * back * back * (3.0 - 2.0 * back) - 1.0);
}

/// 50 frames a second; centimetres, a leg of 86.
inline std::string walking_bvh(const BvhNames& names, int frames, double speed_m_per_s = 1.2) {
  std::string text =
      "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation "
      "Xrotation\n";
  const auto begin = [&](const char* name, double x, double y, double z, bool turns = false) {
    text += fmt::format("JOINT {}\n{{\nOFFSET {} {} {}\nCHANNELS {}\n", names.at(name), x, y, z,
                        turns ? "1 Xrotation" : "0");
  };
  const auto end = [&](int count) {
    for (int n = 0; n < count; ++n) text += "}\n";
  };
  begin("Neck", 0, 50, 0);
  end(1);
  for (const std::string side : {"Left", "Right"}) {
    const double out = side == "Left" ? 1.0 : -1.0;
    begin((side + "UpLeg").c_str(), 9 * out, 0, 0, true);
    begin((side + "Leg").c_str(), 0, -43, 0);
    begin((side + "Foot").c_str(), 0, -43, 0);
    begin((side + "ToeBase").c_str(), 0, -5, 13);
    end(4);
    begin((side + "Arm").c_str(), 18 * out, 45, 0, true);
    begin((side + "ForeArm").c_str(), 0, -30, 0);
    begin((side + "Hand").c_str(), 0, -25, 0);
    end(3);
  }
  text += fmt::format("}}\nMOTION\nFrames: {}\nFrame Time: 0.02\n", frames);
  for (int n = 0; n < frames; ++n) {
    const double time_s = 0.02 * n, left = swing_degrees(time_s), right = swing_degrees(time_s + 0.5);
    text += fmt::format("0 92 {:.4f} 0 0 0 {:.4f} {:.4f} {:.4f} {:.4f}\n", 100.0 * speed_m_per_s * time_s,
                        -left, left, -right, right);
  }
  return text;
}

}  // namespace prairie
