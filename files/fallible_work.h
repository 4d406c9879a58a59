// Work on an input, done by a worker process, whose faults arrive as if it had been done here.
#pragma once

#include "files/worker_process.h"

namespace prairie {

/// Work that throws BadInput or std::bad_alloc, made fit for a worker.
Work fallible(Work work);

/// The work named by the request's first text.
Work chosen_by_name(std::vector<std::pair<std::string, Work>> works);

/// What the work is done on.
struct WorkInput {
  std::string file;
  std::string field;
};

/// Throws the BadInput that the work threw, and one that names the input where the worker did not end by
/// itself.
void run_fallible(WorkerProcess& process, std::span<const std::byte> request, const WorkLimits& limits,
                  const WorkInput& input, const MessageSink& on_reply);

}  // namespace prairie
