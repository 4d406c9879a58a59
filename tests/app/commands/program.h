// Runs the program as a person would, and tells what came of it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace prairie::testing {

struct Outcome {
  int exit_code = -1;  // 128 + the signal's number where one ended it
  std::string out;
  std::string err;
  double seconds = 0.0;
  long largest_memory_mib = 0;  // resident
};

struct Call {
  std::vector<std::string> arguments;
  std::filesystem::path folder = {};                    // to run in; the test's own where empty
  std::map<std::string, std::string> environment = {};  // added to the test's own
  std::function<void()> before_start = {};              // in the new process
  std::filesystem::path program = PRAIRIE_PROGRAM;
};

Outcome run(const Call& call);

/// The program with these arguments.
Outcome prairie(const std::vector<std::string>& arguments);

/// Starts without waiting; `finish` waits. For calls that are interrupted.
class Running {
 public:
  explicit Running(const Call& call);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  int process() const { return process_; }
  Outcome finish();

 private:
  std::filesystem::path out_;
  std::filesystem::path err_;
  int process_ = -1;
  double started_s_ = 0.0;
};

}  // namespace prairie::testing
