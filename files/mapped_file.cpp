#include "files/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "files/error.h"

namespace prairie {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  bool is_mapped = file >= 0 && fstat(file, &status) == 0;
  if (is_mapped && status.st_size > 0) {
    size_bytes_ = static_cast<std::size_t>(status.st_size);
    start_ = mmap(nullptr, size_bytes_, PROT_READ, MAP_PRIVATE, file, 0);
    is_mapped = start_ != MAP_FAILED;
  }
  const int error = errno;
  if (file >= 0) close(file);
  if (!is_mapped) throw BadInput(path.string(), "", std::strerror(error), "a readable file");
}

MappedFile::~MappedFile() {
  if (start_ != nullptr) munmap(start_, size_bytes_);
}

}  // namespace prairie
