// Maps decoded by a worker process: what crashes, hangs or swells over a person's file is one line that names
// it (docs/design.md, D8).
#pragma once

#include "files/worker_process.h"
#include "maps/map_decoding.h"

namespace prairie {

/// What a worker has to know for `decode_map` and `layout_of_map` below (files/fallible_work.h).
std::vector<std::pair<std::string, Work>> map_works();

/// As the functions of maps/map_decoding.h, by `decoder`, or in this process where there is none. The decoder
/// may use `memory_bytes` beside what every decoder needs.
MapSummary decode_map(const MapRequest& request, std::uint64_t memory_bytes, WorkerProcess* decoder,
                      MapSink& sink);
MapLayout layout_of_map(const MapRequest& request, WorkerProcess* decoder);

}  // namespace prairie
