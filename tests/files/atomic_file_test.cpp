#include "files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "files/error.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

std::string text_of(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = testing::read_bytes(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a.txt", "one");
  EXPECT_EQ(text_of(folder / "a.txt"), "one");
  write_file_atomically(folder / "a.txt", "");
  EXPECT_EQ(text_of(folder / "a.txt"), "");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, WithoutAFolderFailsAndSaysWhere) {
  const TemporaryFolder folder;
  try {
    write_file_atomically(folder / "missing/a.txt", "one");
    FAIL();
  } catch (const OutputFailure& failure) {
    EXPECT_EQ(failure.file, (folder / "missing/a.txt").string());
    EXPECT_EQ(failure.found, "No such file or directory");
  }
}

TEST(AtomicFile, OverAFolderFailsAndLeavesNothing) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a");
  EXPECT_THROW(write_file_atomically(folder / "a", "one"), OutputFailure);
  EXPECT_EQ(files_in(folder.path()), 1);
}

/// Fails to write a megabyte over "a.txt" in `folder`, then looks at what is left.
bool fails_and_leaves_intact(const std::filesystem::path& folder) {
  const std::string large(1 << 20, 'x');
  try {
    write_file_atomically(folder / "a.txt", large);
    return false;
  } catch (const OutputFailure&) {
    return text_of(folder / "a.txt") == "precious" && files_in(folder) == 1;
  }
}

TEST(AtomicFile, FullDiskLeavesWhatWasThere) {
  const TemporaryFolder folder;
  if (::mount("none", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0) {
    GTEST_SKIP() << "a small file system can only be mounted by root";
  }
  write_file_atomically(folder / "a.txt", "precious");
  EXPECT_TRUE(fails_and_leaves_intact(folder.path()));
  ::umount(folder.path().c_str());
}

TEST(AtomicFile, FileSizeLimitLeavesWhatWasThere) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a.txt", "precious");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{64 * 1024, 64 * 1024};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(fails_and_leaves_intact(folder.path()) ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace prairie
