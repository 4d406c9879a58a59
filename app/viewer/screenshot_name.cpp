#include "app/viewer/screenshot_name.h"

#include <fmt/format.h>

namespace prairie {

std::filesystem::path free_screenshot_name(const std::filesystem::path& folder) {
  for (int number = 1;; ++number) {
    std::filesystem::path name = folder / fmt::format("prairie-{:04}.png", number);
    if (!std::filesystem::exists(name)) return name;
  }
}

}  // namespace prairie
