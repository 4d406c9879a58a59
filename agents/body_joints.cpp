#include "agents/body_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/error.h"

namespace prairie {
namespace {

// The names that files give the parts, the likeliest first, beside a word or letter for the side.
constexpr std::array<std::string_view, 5> kHipNames = {"upleg", "thigh", "upperleg", "femur", "hip"};
constexpr std::array<std::string_view, 6> kKneeNames = {"leg", "lowleg", "shin", "calf", "lowerleg", "knee"};
constexpr std::array<std::string_view, 2> kAnkleNames = {"foot", "ankle"};
constexpr std::array<std::string_view, 4> kToesNames = {"toebase", "toes", "toe", "ball"};
constexpr std::array<std::string_view, 5> kShoulderNames = {"arm", "upperarm", "uparm", "shldr", "shoulder"};
constexpr std::array<std::string_view, 4> kElbowNames = {"forearm", "lowerarm", "lowarm", "elbow"};
constexpr std::array<std::string_view, 2> kWristNames = {"hand", "wrist"};
constexpr std::array<std::span<const std::string_view>, kBodyPartCount> kPartNames = {
    kHipNames, kKneeNames, kAnkleNames, kToesNames, kShoulderNames, kElbowNames, kWristNames};
constexpr std::array<std::string_view, kBodyPartCount> kPartShown = {"hip",      "knee",  "ankle", "toes",
                                                                     "shoulder", "elbow", "wrist"};
constexpr std::array<std::string_view, 3> kNeckNames = {"neck", "neck1", "head"};
constexpr const char* kUsualNames =
    "names such as LeftUpLeg, LeftLeg, LeftFoot, LeftToeBase, LeftArm, LeftForeArm, LeftHand and Neck; or "
    "thigh, calf or "
    "shin, foot, toe, upper_arm, forearm, hand with L and R; or L_Hip, L_Knee, L_Ankle, L_Foot, L_Shoulder, "
    "L_Elbow, "
    "L_Wrist";

/// "DEF-upper_leg.L" is def, upper, leg, l; "LeftUpLeg" is left, up, leg.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool begins = true;
  for (std::size_t n = 0; n < name.size(); ++n) {
    const auto byte = static_cast<unsigned char>(name[n]);
    if (std::isalnum(byte) == 0) {
      begins = true;
      continue;
    }
    const bool after_small = n > 0 && std::islower(static_cast<unsigned char>(name[n - 1])) != 0;
    const bool before_small = n > 0 && n + 1 < name.size() &&
                              std::isupper(static_cast<unsigned char>(name[n - 1])) != 0 &&
                              std::islower(static_cast<unsigned char>(name[n + 1])) != 0;
    if (begins || (std::isupper(byte) != 0 && (after_small || before_small))) words.emplace_back();
    begins = false;
    words.back().push_back(static_cast<char>(std::tolower(byte)));
  }
  return words;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// What a name says of its joint.
struct Reading {
  std::optional<bool> is_right;
  std::string rest;  // all other words
};

/// Takes the word for a side off one end of another, where both are written as one.
void part_side(std::string& word, std::optional<bool>& is_right) {
  for (const bool right : {false, true}) {
    const std::string_view side = right ? "right" : "left";
    if (word.size() > side.size() && word.starts_with(side)) {
      is_right = right;
      word.erase(0, side.size());
      return;
    }
    if (word.size() > side.size() && word.ends_with(side)) {
      is_right = right;
      word.erase(word.size() - side.size());
      return;
    }
  }
}

Reading reading_of(const std::string& name) {
  std::vector<std::string> words = words_of(name);
  Reading reading;
  // ".001" is a second piece of the same bone.
  if (words.size() > 1 && is_number(words.back())) return reading;
  const auto is_side = [](const std::string& word) {
    return word == "left" || word == "right" || word == "l" || word == "r";
  };
  // The last one: Biped's and other prefixes may hold letters of their own.
  for (std::size_t n = words.size(); n-- > 0 && !reading.is_right;) {
    if (!is_side(words[n])) continue;
    reading.is_right = words[n].front() == 'r';
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(n));
  }
  if (!reading.is_right) {
    for (std::string& word : words) {
      if (!reading.is_right) part_side(word, reading.is_right);
    }
  }
  for (const std::string& word : words) reading.rest += word;
  while (!reading.rest.empty() && std::isdigit(static_cast<unsigned char>(reading.rest.back())) != 0)
    reading.rest.pop_back();
  return reading;
}

/// "lthigh" and "thighl", where nothing parts the letter from the name.
bool is_lettered(const std::string& rest, std::string_view part_name, bool right) {
  const char letter = right ? 'r' : 'l';
  return rest.size() == part_name.size() + 1 && ((rest.front() == letter && rest.ends_with(part_name)) ||
                                                 (rest.back() == letter && rest.starts_with(part_name)));
}

/// The longest of all parts' names that a name ends with.
std::string_view longest_ending(const std::string& rest) {
  std::string_view longest;
  for (const auto& names : kPartNames) {
    for (const std::string_view name : names) {
      if (rest.ends_with(name) && name.size() > longest.size()) longest = name;
    }
  }
  return longest;
}

class JointFinder {
 public:
  explicit JointFinder(const BvhMotion& motion) : motion_(motion) {
    for (const BvhJoint& joint : motion.joints) readings_.push_back(reading_of(joint.name));
  }

  BodyJoints find() {
    BodyJoints joints;
    for (const bool right : {false, true}) {
      auto& of_side = joints.of_side[right ? 1 : 0];
      for (int part = 0; part < kBodyPartCount; ++part) {
        if (const auto found = find_part(part, right))
          of_side[static_cast<std::size_t>(part)] = *found;
        else
          missing_.push_back(
              fmt::format("{} {}", right ? "right" : "left", kPartShown[static_cast<std::size_t>(part)]));
      }
    }
    if (const auto neck = find_neck())
      joints.neck = *neck;
    else
      missing_.emplace_back("neck");
    if (!missing_.empty()) {
      throw BadInput(motion_.file, "joints",
                     fmt::format("no {}, among {}", fmt::join(missing_, ", no "), names_seen()), kUsualNames);
    }
    return joints;
  }

 private:
  std::optional<std::size_t> find_named(std::string_view name, bool right) const {
    for (std::size_t n = 0; n < readings_.size(); ++n) {
      const Reading& reading = readings_[n];
      if (!reading.is_right && is_lettered(reading.rest, name, right)) return n;
      if (reading.is_right == right && longest_ending(reading.rest) == name) return n;
    }
    return std::nullopt;
  }
  std::optional<std::size_t> find_part(int part, bool right) const {
    const std::optional<std::size_t> ankle = find_named("ankle", right), foot = find_named("foot", right);
    const bool foot_is_toes = ankle && foot && motion_.joints[*foot].parent == static_cast<int>(*ankle);
    if (part == kAnkle && foot_is_toes) return ankle;
    for (const std::string_view name : kPartNames[static_cast<std::size_t>(part)]) {
      if (const auto found = find_named(name, right)) return found;
    }
    if (part != kToes) return std::nullopt;
    if (foot_is_toes) return foot;
    // Short skeletons end in the foot, and its end site is the toes.
    const auto last = find_part(kAnkle, right);
    return last ? end_site_of(*last) : std::nullopt;
  }
  std::optional<std::size_t> find_neck() const {
    for (const std::string_view name : kNeckNames) {
      for (std::size_t n = 0; n < readings_.size(); ++n) {
        if (!readings_[n].is_right && readings_[n].rest.ends_with(name)) return n;
      }
    }
    return std::nullopt;
  }
  std::optional<std::size_t> end_site_of(std::size_t parent) const {
    for (std::size_t n = parent; n < motion_.joints.size(); ++n) {
      if (motion_.joints[n].parent == static_cast<int>(parent) && motion_.joints[n].name.empty()) return n;
    }
    return std::nullopt;
  }
  std::string names_seen() const {
    constexpr std::size_t kMostShown = 12;
    std::vector<std::string> names;
    for (const BvhJoint& joint : motion_.joints) {
      if (!joint.name.empty() && names.size() < kMostShown) names.push_back(joint.name.substr(0, 40));
    }
    return fmt::format("{}{}", fmt::join(names, ", "), motion_.joints.size() > kMostShown ? ", …" : "");
  }

  const BvhMotion& motion_;
  std::vector<Reading> readings_;
  std::vector<std::string> missing_;
};

}  // namespace

BodyJoints find_body_joints(const BvhMotion& motion) {
  return JointFinder(motion).find();
}

}  // namespace prairie
