#include "agents/bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <optional>
#include <utility>

#include "animation/heading.h"
#include "files/csv_table.h"
#include "files/decimal.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kMostName = 128;
constexpr std::size_t kMostFrames = 200'000;
constexpr std::size_t kMostPlaces = 20'000'000;  // of joints in all frames
constexpr double kMostMagnitude = 1e6;

constexpr std::array<std::string_view, 6> kChannelNames = {"Xposition", "Yposition", "Zposition",
                                                           "Xrotation", "Yrotation", "Zrotation"};

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

/// The words of a text, and the line of the last.
class Words {
 public:
  Words(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  /// Empty at the end.
  std::string_view next() {
    skip_blanks();
    std::size_t length = 0;
    while (length < rest_.size() && !is_blank(rest_[length])) ++length;
    return taken(length);
  }
  std::string_view peek() const {
    Words copy = *this;
    return copy.next();
  }
  /// What is left of the line: names may hold blanks.
  std::string_view rest_of_line() {
    const std::string_view line = taken(std::min(rest_.find_first_of("\r\n"), rest_.size()));
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(" \t") - first + 1);
  }
  void need(std::string_view word) {
    const std::string_view found = next();
    if (!same_word(found, word)) refuse(found, fmt::format("\"{}\"", word));
  }
  double number() {
    const std::string_view word = next();
    const std::optional<double> value = parse_decimal(word);
    if (!value || !(std::abs(*value) <= kMostMagnitude))
      refuse(word, fmt::format("a number, at most {} in magnitude", kMostMagnitude));
    return *value;
  }
  std::size_t count(std::size_t low, std::size_t high) {
    const std::string_view word = next();
    const std::optional<double> value = parse_decimal(word);
    if (!value || !(*value >= static_cast<double>(low) && *value <= static_cast<double>(high)) ||
        *value != std::floor(*value)) {
      refuse(word, fmt::format("a whole number, {} to {}", low, high));
    }
    return static_cast<std::size_t>(*value);
  }
  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
    constexpr std::size_t kShown = 40;
    throw BadInput(file_, fmt::format("line {}", line_),
                   found.empty() ? "the end of the file" : fmt::format("\"{}\"", found.substr(0, kShown)),
                   expected);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  void skip_blanks() {
    std::size_t blanks = 0;
    for (; blanks < rest_.size() && is_blank(rest_[blanks]); ++blanks) line_ += rest_[blanks] == '\n' ? 1 : 0;
    rest_.remove_prefix(blanks);
  }
  std::string_view taken(std::size_t length) {
    const std::string_view part = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return part;
  }

  std::string_view rest_;
  const std::string& file_;
  std::size_t line_ = 1;
};

void read_channels(Words& words, BvhMotion& motion, BvhJoint& joint) {
  joint.first_value = motion.values_per_frame;
  const std::size_t count = words.count(0, kChannelNames.size());
  for (std::size_t n = 0; n < count; ++n) {
    const std::string_view word = words.next();
    const auto found = std::find_if(kChannelNames.begin(), kChannelNames.end(),
                                    [word](std::string_view name) { return same_word(name, word); });
    if (found == kChannelNames.end()) words.refuse(word, "a channel such as Xposition or Zrotation");
    joint.channels.push_back(static_cast<BvhChannel>(found - kChannelNames.begin()));
  }
  motion.values_per_frame += count;
}

/// From the first joint's name on. Open joints are kept in a list, so that depth costs no stack.
void read_hierarchy(Words& words, BvhMotion& motion) {
  std::vector<int> open;
  const auto begin_joint = [&](std::string_view name) {
    if (motion.joints.size() == kMostBvhJoints)
      words.refuse(name, fmt::format("at most {} joints", kMostBvhJoints));
    if (name.size() > kMostName)
      words.refuse(name, fmt::format("a name of at most {} characters", kMostName));
    BvhJoint joint;
    joint.name = name;
    joint.parent = open.empty() ? -1 : open.back();
    open.push_back(static_cast<int>(motion.joints.size()));
    motion.joints.push_back(std::move(joint));
    words.need("{");
  };
  const auto begin_named = [&] {
    const std::string_view name = words.rest_of_line();
    if (name.empty()) words.refuse(words.peek(), "a name on the joint's line");
    begin_joint(name);
  };
  words.need("HIERARCHY");
  words.need("ROOT");
  begin_named();
  while (!open.empty()) {
    const std::string_view word = words.next();
    BvhJoint& joint = motion.joints[static_cast<std::size_t>(open.back())];
    if (same_word(word, "OFFSET")) {
      for (int axis = 0; axis < 3; ++axis) joint.offset[axis] = words.number();
    } else if (same_word(word, "CHANNELS") && !joint.name.empty() && joint.channels.empty()) {
      read_channels(words, motion, joint);
    } else if (same_word(word, "JOINT") && !joint.name.empty()) {
      begin_named();
    } else if (same_word(word, "End") && !joint.name.empty()) {
      words.need("Site");
      begin_joint({});
    } else if (word == "}") {
      open.pop_back();
    } else {
      words.refuse(word, "OFFSET, CHANNELS, JOINT, End Site or }, once each where it belongs");
    }
  }
}

void read_frames(Words& words, std::size_t text_bytes, BvhMotion& motion) {
  words.need("MOTION");
  if (motion.values_per_frame == 0) words.refuse("MOTION", "a hierarchy with channels before it");
  words.need("Frames:");
  const std::size_t frames = words.count(1, kMostFrames);
  words.need("Frame");
  words.need("Time:");
  const std::string_view word = words.peek();
  motion.frame_s = words.number();
  if (!(motion.frame_s >= 1e-4 && motion.frame_s <= 1.0)) words.refuse(word, "a frame time, 0.0001 to 1 s");
  // A value takes two characters at least: no more memory is asked for than the text can fill.
  if (frames > text_bytes / 2 / motion.values_per_frame)
    words.refuse("Frames:", fmt::format("as many values as {} frames need", frames));
  if (frames * motion.joints.size() > kMostPlaces)
    words.refuse("Frames:", fmt::format("at most {} frames of {} joints", kMostPlaces / motion.joints.size(),
                                        motion.joints.size()));
  motion.values.reserve(frames * motion.values_per_frame);
  for (std::size_t n = 0; n < frames * motion.values_per_frame; ++n) motion.values.push_back(words.number());
  const std::string_view more = words.next();
  if (!more.empty()) words.refuse(more, fmt::format("the end of the file after {} frames", frames));
}

/// About axis 0, 1 or 2.
glm::dmat3 rotation_about(int axis, double degrees) {
  const double turns = degrees / 360.0;
  const double s = sine_of_turns(turns), c = sine_of_turns(turns + 0.25);
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  glm::dmat3 matrix(1.0);
  matrix[next][next] = c;
  matrix[next][last] = s;
  matrix[last][next] = -s;
  matrix[last][last] = c;
  return matrix;
}

}  // namespace

BvhMotion parse_bvh(std::string_view text, const std::string& file) {
  BvhMotion motion;
  motion.file = file;
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Words words(text, file);
  read_hierarchy(words, motion);
  read_frames(words, text.size(), motion);
  return motion;
}

BvhMotion read_bvh(const std::filesystem::path& path, const std::string& field) {
  return parse_bvh(read_text_input(path, field, kMostBvhBytes), path.string());
}

void place_joints(const BvhMotion& motion, std::size_t frame, std::span<glm::dvec3> places) {
  assert(frame < motion.frame_count() && places.size() == motion.joints.size());
  std::vector<glm::dmat3> axes(motion.joints.size());
  for (std::size_t n = 0; n < motion.joints.size(); ++n) {
    const BvhJoint& joint = motion.joints[n];
    const double* values = &motion.values[frame * motion.values_per_frame + joint.first_value];
    glm::dvec3 offset = joint.offset, moved(0.0);
    glm::dmat3 turn(1.0);
    bool moves = false;
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
      const int channel = static_cast<int>(joint.channels[c]);
      if (channel < 3) {
        moved[channel] = values[c];
        moves = true;
      } else {
        turn = turn * rotation_about(channel - 3, values[c]);
      }
    }
    // A joint's position replaces its offset; programs that write them for every joint repeat the offset
    // there.
    if (moves) offset = moved;
    const bool has_parent = joint.parent >= 0;
    const std::size_t parent = has_parent ? static_cast<std::size_t>(joint.parent) : 0;
    places[n] = has_parent ? places[parent] + axes[parent] * offset : offset;
    axes[n] = has_parent ? axes[parent] * turn : turn;
  }
}

}  // namespace prairie
