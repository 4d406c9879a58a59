// One function per measurement; bench.cpp lists them by name.
#pragma once

#include "bench/bench.h"

namespace prairie {

/// Blades per second that one core plants on a meadow whose density varies from node to node.
double planting_cpu_blades_per_s_core(const BenchOptions& options);

/// Nanoseconds that a blade takes to be planted and stored by the compute shader, median of full storage buffers.
double planting_gpu_ns_per_blade(const BenchOptions& options);

}  // namespace prairie
