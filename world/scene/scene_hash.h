// One number for "the same scene": equal wherever the folder lies and whatever its map files are called,
// different as soon as a setting or a byte of a map or of the measured wind differs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "agents/gait.h"
#include "agents/track.h"
#include "world/scene/scene.h"

namespace prairie {

/// Of files' bytes: maps by MapSpec::field, the measured wind by kWindFileField.
using ContentHashes = std::map<std::string, std::uint64_t>;

/// XXH3 of the scene's settings and of its files.
std::uint64_t scene_hash(const Scene& scene, const ContentHashes& files);

/// The same of what grows and moves alone: equal for other cameras, another light, another quality.
std::uint64_t motion_hash(const Scene& scene, const ContentHashes& files);

/// The same where walkers move by another gait.
std::uint64_t motion_hash_with(std::uint64_t motion_hash, const Gait& gait);
/// The same where walkers move along recorded tracks.
std::uint64_t motion_hash_with(std::uint64_t motion_hash, const std::vector<Track>& tracks);

}  // namespace prairie
