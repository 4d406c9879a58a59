// The bytes of a file without reading them into memory: rasters larger than memory can be copied.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace prairie {

class MappedFile {
 public:
  /// Throws BadInput.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(start_), size_bytes_}; }

 private:
  void* start_ = nullptr;
  std::size_t size_bytes_ = 0;
};

}  // namespace prairie
