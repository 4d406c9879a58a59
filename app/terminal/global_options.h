// The options that every command accepts, before or after its name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace prairie {

class WorkerProcess;

struct GlobalOptions {
  std::optional<std::uint64_t> seed;  // overrides the scene's
  std::optional<int> threads;         // unset: as many as there are cores
  std::optional<std::string> device;  // for headless pictures
  std::uint64_t max_memory_bytes = 2ull << 30;
  std::vector<std::string> overrides;  // "key=value" of the scene
  bool quiet = false;
  WorkerProcess* decoder = nullptr;  // opens what other people have made
};

}  // namespace prairie
