#include "app/scenes/installed_files.h"

#include <cstdlib>
#include <system_error>

#include "files/error.h"

namespace prairie {
namespace fs = std::filesystem;
namespace {

bool holds_shaders(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "pass", error);
}

}  // namespace

fs::path shader_folder() {
  constexpr const char* kVariable = "PRAIRIE_SHADERS";
  if (const char* named = std::getenv(kVariable); named != nullptr && *named != '\0') {
    if (!holds_shaders(named)) {
      throw BadInput(named, kVariable, "a folder without shaders",
                     "the folder that holds pass/ and kernels/");
    }
    return named;
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = (program.parent_path() / PRAIRIE_SHADERS_FROM_PROGRAM).lexically_normal();
  if (!error && holds_shaders(installed)) return installed;
  if (holds_shaders(PRAIRIE_SHADERS_IN_SOURCES)) return PRAIRIE_SHADERS_IN_SOURCES;
  throw BadInput(installed.string(), "", "no shaders",
                 std::string("the installed shaders, or their folder in ") + kVariable);
}

}  // namespace prairie
