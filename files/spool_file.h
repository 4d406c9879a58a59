// A temporary file without a name, for data that would not fit into memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace prairie {

/// Lies in the folder for temporary files ($TMPDIR, else /tmp) and is gone with the object.
class SpoolFile {
 public:
  /// Throws OutputFailure where no file can be made.
  SpoolFile();
  ~SpoolFile();
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  /// Throws OutputFailure, as on a full disk.
  void write(std::uint64_t at, std::span<const std::byte> bytes);
  /// Of bytes that were written. Thread-safe. Throws OutputFailure where the disk fails.
  void read(std::uint64_t at, std::span<std::byte> bytes) const;

 private:
  int descriptor_ = -1;
};

}  // namespace prairie
