// One function per bench; bench.cpp lists them with the names of their measurements.
#pragma once

#include <filesystem>

#include "bench/bench.h"

namespace prairie {

/// Blades per second that one core plants on a meadow whose density varies from node to node.
std::vector<Measurement> bench_planting_cpu(const BenchOptions& options);

/// Milliseconds, median, of a step of 100 000 inertial blades, and of 64 × 64 virtual blades with the loads
/// that they leave for drawn ones.
std::vector<Measurement> bench_blade_motion(const BenchOptions& options);

/// Nanoseconds that a blade takes to be planted and stored by the compute shader, median of full storage
/// buffers.
std::vector<Measurement> bench_planting_gpu(const BenchOptions& options);

/// Milliseconds, median, of a step in which 1000 bodies tread.
std::vector<Measurement> bench_treading(const BenchOptions& options);

/// Milliseconds, median, in which 64 × 64 nodes of wind are filled: mean, noise, a gust, a tornado and a
/// breeze.
std::vector<Measurement> bench_wind_nodes(const BenchOptions& options);

/// Pairs of boxes per second whose distance and nearest points are told, from cold and from a cache while
/// they move slowly, medians of interleaved rounds; the same of FCL's two solvers, and how many times as many
/// we tell as the faster.
std::vector<Measurement> bench_gjk(const BenchOptions& options);

/// Milliseconds, median, of a step of 1/30 s of 1000 and of 10 000 walkers at 0.04 per m², with what they
/// perceive, decide and tread.
std::vector<Measurement> bench_walker_steps(const BenchOptions& options);

/// What 200 walkers in view add to a frame of the walk of `scale`, their step included, frame by frame in
/// turn.
std::vector<Measurement> bench_walker_frames(const BenchOptions& options);

// A walk over a square kilometre of a billion blades (bench/scale_scene.h):
/// how long its frames take, what stands in which tier;
std::vector<Measurement> bench_scale_walk(const BenchOptions& options);
/// what denser and larger fields cost;
std::vector<Measurement> bench_table1(const BenchOptions& options);
std::vector<Measurement> bench_scale_variants(const BenchOptions& options);
/// how long it takes to start and what memory it needs, in processes of their own;
std::vector<Measurement> bench_scale_processes(const BenchOptions& options);
/// a frame of it against the same picture of 3D blades alone.
std::vector<Measurement> bench_scale_picture(const BenchOptions& options);

/// Each tier, at the distance at which it gives way to the next, against the all-3D picture.
std::vector<Measurement> bench_tier_pictures(const BenchOptions& options);

// How evenly the picture changes while tiles go through a band:
/// from spline to Hermite blades,
std::vector<Measurement> bench_spline_border(const BenchOptions& options);
/// from blades to strips,
std::vector<Measurement> bench_strip_border(const BenchOptions& options);
/// from strips to the ground's texture.
std::vector<Measurement> bench_flat_border(const BenchOptions& options);

}  // namespace prairie
