#include "bench/scale_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "files/error.h"

namespace prairie {

namespace fs = std::filesystem;

BenchFolder::BenchFolder() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "prairie-bench-XXXXXX").string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw OutputFailure(name, "", std::generic_category().message(errno), "a folder for temporary files");
  }
  path_ = name;
}

BenchFolder::~BenchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace prairie
