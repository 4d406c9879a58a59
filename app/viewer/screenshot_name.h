// Names for screenshots that replace nothing: prairie-0001.png, prairie-0002.png, …
#pragma once

#include <filesystem>

namespace prairie {

/// The first name in `folder` that is not taken.
std::filesystem::path free_screenshot_name(const std::filesystem::path& folder);

}  // namespace prairie
