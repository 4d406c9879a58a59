#include "app/outputs/picture_file.h"

#include <fmt/format.h>

#include "app/terminal/usage_error.h"
#include "pictures/picture_encoding.h"

namespace prairie {
namespace {

// Linear and sRGB copies, the sum of the samples, colour and depth targets, and the encoded bytes.
constexpr std::uint64_t kBytesPerPixel = 12 + 3 + 16 + 16 + 8 + 12;

}  // namespace

PictureFormat picture_format(const std::filesystem::path& path) {
  const std::string suffix = path.extension().string();
  if (suffix == ".png" || suffix == ".PNG") return PictureFormat::kPng;
  if (suffix == ".exr" || suffix == ".EXR") return PictureFormat::kExr;
  throw UsageError("--output", path.string(), "a file name that ends in .png or .exr");
}

std::vector<std::byte> encoded_picture(const Picture& picture, PictureFormat format) {
  if (format == PictureFormat::kExr) return encode_exr_rgb(picture.width, picture.height, picture.linear_rgb);
  return encode_png_rgb8(picture.width, picture.height, picture.srgb);
}

void check_picture_budget(glm::ivec2 size_px, std::uint64_t budget_bytes) {
  const std::uint64_t needed =
      static_cast<std::uint64_t>(size_px.x) * static_cast<std::uint64_t>(size_px.y) * kBytesPerPixel;
  if (needed <= budget_bytes) return;
  throw OverBudget("", "--size", fmt::format("a picture that needs {} MiB", needed >> 20),
                   fmt::format("at most the {} MiB of --max-memory", budget_bytes >> 20));
}

}  // namespace prairie
