#include "files/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20;

/// An ordinary file that is not empty, open for reading.
class OpenInput {
 public:
  OpenInput(const std::filesystem::path& path, const std::string& field)
      // A pipe without a writer would block here for ever.
      : path_(path), field_(field), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) fail(std::strerror(errno));
    try {
      look();
    } catch (...) {
      ::close(descriptor_);
      throw;
    }
  }
  OpenInput(const OpenInput&) = delete;
  OpenInput& operator=(const OpenInput&) = delete;
  ~OpenInput() { ::close(descriptor_); }

  /// When it was opened.
  std::uint64_t bytes() const { return bytes_; }

  /// Up to so many of the bytes that follow; none at the end.
  std::size_t read(void* to, std::size_t most) const {
    while (true) {
      const ssize_t count = ::read(descriptor_, to, most);
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno != EINTR) fail(std::strerror(errno));
    }
  }

  [[noreturn]] void fail(const std::string& found,
                         const std::string& expected = "a file that can be read") const {
    throw BadInput(path_.string(), field_, found, expected);
  }

 private:
  void look() {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail(std::strerror(errno));
    if (S_ISDIR(status.st_mode)) fail("a folder");
    if (!S_ISREG(status.st_mode)) fail("something that is not a file");
    if (status.st_size == 0) fail("an empty file");
    bytes_ = static_cast<std::uint64_t>(status.st_size);
  }

  const std::filesystem::path& path_;
  const std::string& field_;
  int descriptor_;
  std::uint64_t bytes_ = 0;
};

}  // namespace

InputFile inspect_input(const std::filesystem::path& path, const std::string& field) {
  return inspect_inputs({path}, field);
}

InputFile inspect_inputs(const std::vector<std::filesystem::path>& paths, const std::string& field) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
  XXH3_64bits_reset(state.get());
  InputFile result;
  std::vector<char> chunk(kChunkBytes);
  for (const std::filesystem::path& path : paths) {
    const OpenInput file(path, field);
    while (const std::size_t count = file.read(chunk.data(), chunk.size())) {
      XXH3_64bits_update(state.get(), chunk.data(), count);
      result.bytes += count;
    }
  }
  result.hash = XXH3_64bits_digest(state.get());
  return result;
}

void check_input(const std::filesystem::path& path, const std::string& field) {
  const OpenInput file(path, field);
}

std::vector<std::byte> read_input(const std::filesystem::path& path, const std::string& field,
                                  std::uint64_t most_bytes) {
  const OpenInput file(path, field);
  if (file.bytes() > most_bytes)
    file.fail(fmt::format("{} bytes", file.bytes()), fmt::format("at most {}", most_bytes));
  std::vector<std::byte> bytes(file.bytes());
  std::size_t length = 0;
  while (length < bytes.size()) {
    const std::size_t count = file.read(bytes.data() + length, bytes.size() - length);
    if (count == 0) break;
    length += count;
  }
  bytes.resize(length);  // shorter where somebody cuts it meanwhile
  return bytes;
}

}  // namespace prairie
