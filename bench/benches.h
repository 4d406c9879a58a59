// One function per measurement; bench.cpp lists them by name.
#pragma once

#include "bench/bench.h"

namespace prairie {

/// Blades per second that one core plants on a meadow whose density varies from node to node.
double planting_cpu_blades_per_s_core(const BenchOptions& options);

}  // namespace prairie
