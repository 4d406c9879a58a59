// How far a long command has come, on one line of the terminal that is written over and at last wiped away.
// Where stderr is no terminal, nothing is shown.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace prairie {

class Progress {
 public:
  Progress(std::string what, std::uint64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more of `total` is done.
  void advance();

 private:
  std::string what_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  bool shown_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace prairie
