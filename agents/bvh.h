// Recorded motion from a BVH file (Biovision hierarchy): a tree of joints with their offsets, and for each
// frame the values of their channels. The format has no standard; this follows Meredith and Maddock 2001,
// "Motion Capture File Formats Explained". A person's file is checked in full before it is believed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prairie {

enum class BvhChannel { kXPosition, kYPosition, kZPosition, kXRotation, kYRotation, kZRotation };

struct BvhJoint {
  std::string name;        // empty for an end site
  int parent = -1;         // before it in the list; −1: none
  glm::dvec3 offset{0.0};  // from its parent, in the file's unit
  std::vector<BvhChannel> channels;
  std::size_t first_value = 0;  // of a frame's
};

struct BvhMotion {
  std::string file;  // for messages
  std::vector<BvhJoint> joints;
  double frame_s = 0.0;
  std::size_t values_per_frame = 0;
  std::vector<double> values;  // frame by frame; lengths in the file's unit, angles in degrees

  std::size_t frame_count() const { return values.size() / values_per_frame; }
};

inline constexpr std::size_t kMostBvhBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMostBvhJoints = 1000;

/// Throws BadInput, the line in its field, where the text is not BVH: braces that do not match, more joints
/// than kMostBvhJoints, channels that are unknown, numbers that are none or not finite, too few or too many
/// frames or values.
BvhMotion parse_bvh(std::string_view text, const std::string& file);
/// `field` names what asked for the file.
BvhMotion read_bvh(const std::filesystem::path& path, const std::string& field);

/// Where the joints of one frame are, in the file's frame and unit; `places[j]` for joint j.
void place_joints(const BvhMotion& motion, std::size_t frame, std::span<glm::dvec3> places);

}  // namespace prairie
