// Pictures into files, by suffix, within the memory budget.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

#include "pictures/picture.h"

namespace prairie {

enum class PictureFormat { kPng, kExr };

/// By the suffix of `path`. Throws UsageError for any other than .png and .exr.
PictureFormat picture_format(const std::filesystem::path& path);

/// 8-bit sRGB for PNG, linear float for EXR.
std::vector<std::byte> encoded_picture(const Picture& picture, PictureFormat format);

/// Throws OverBudget where a picture of this size needs more memory than `budget_bytes` on its way to the
/// file.
void check_picture_budget(glm::ivec2 size_px, std::uint64_t budget_bytes);

}  // namespace prairie
