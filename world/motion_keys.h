// What moves over the grass and how the grass bears it: the sections [treading] and [[mover]] of a scene, and
// a species' motion.
#pragma once

#include <string>
#include <vector>

#include "world/scene.h"
#include "world/toml_reader.h"

namespace prairie {

// All throw BadInput.
void read_blade_motion(TableReader& species, BladeMotionSpec& motion);
TreadSettings read_treading(TableReader& table);
/// `taken`: names of the movers before it.
MoverSpec read_mover(TableReader& table, const std::vector<std::string>& taken);

}  // namespace prairie
