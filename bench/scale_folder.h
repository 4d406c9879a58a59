// A folder of its own for what a bench writes: new and empty, gone with all it holds when the bench is over.
#pragma once

#include <filesystem>

namespace prairie {

class BenchFolder {
 public:
  /// Throws OutputFailure.
  BenchFolder();
  ~BenchFolder();
  BenchFolder(const BenchFolder&) = delete;
  BenchFolder& operator=(const BenchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace prairie
