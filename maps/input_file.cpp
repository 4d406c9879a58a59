#include "maps/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "maps/error.h"

namespace prairie {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20;

class Descriptor {
 public:
  // A pipe without a writer would block here for ever.
  explicit Descriptor(const char* path) : value_(::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int get() const { return value_; }

 private:
  int value_;
};

}  // namespace

InputFile inspect_input(const std::filesystem::path& path, const std::string& field) {
  const auto fail = [&](const char* found) {
    throw BadInput(path.string(), field, found, "a file that can be read");
  };
  const Descriptor file(path.c_str());
  if (file.get() < 0) fail(std::strerror(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(std::strerror(errno));
  if (S_ISDIR(status.st_mode)) fail("a folder");
  if (!S_ISREG(status.st_mode)) fail("something that is not a file");
  if (status.st_size == 0) fail("an empty file");

  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
  XXH3_64bits_reset(state.get());
  InputFile result;
  std::vector<char> chunk(kChunkBytes);
  while (true) {
    const ssize_t count = ::read(file.get(), chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(std::strerror(errno));
    if (count == 0) break;
    XXH3_64bits_update(state.get(), chunk.data(), static_cast<std::size_t>(count));
    result.bytes += static_cast<std::uint64_t>(count);
  }
  result.hash = XXH3_64bits_digest(state.get());
  return result;
}

}  // namespace prairie
