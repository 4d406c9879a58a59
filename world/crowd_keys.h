// Who walks and what stands in the way: the sections [[obstacle]], [[wall]], [[goal]] and [[walkers]] of a
// scene.
#pragma once

#include "world/scene.h"
#include "world/toml_reader.h"

namespace prairie {

/// All four, from the whole file's table. Throws BadInput.
void read_crowd(TableReader& root, Scene& scene);

}  // namespace prairie
