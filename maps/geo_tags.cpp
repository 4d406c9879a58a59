#include "maps/geo_tags.h"

#include <tiffio.h>

#include <array>
#include <cstdarg>
#include <fstream>
#include <memory>
#include <string_view>

#include "files/decimal.h"
#include "maps/geotiff_tags.h"

namespace prairie {
namespace {

// Real tags hold a few hundred values; a file that claims more is not worth the memory.
constexpr std::size_t kMaxValues = 1 << 16;
constexpr tmsize_t kMaxAllocationBytes = tmsize_t{1} << 28;  // libtiff's tables of strips, for one

int ignore_message(TIFF*, void*, const char*, const char*, va_list) {
  return 1;
}

bool is_tiff(const std::filesystem::path& path) {
  std::array<char, 4> head{};
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(head.data(), head.size())) return false;
  const std::string_view magic(head.data(), head.size());
  using namespace std::string_view_literals;
  return magic == "II*\0"sv || magic == "MM\0*"sv || magic == "II+\0"sv || magic == "MM\0+"sv;
}

/// The values of a tag that nobody declared to libtiff, which then hands it out with the type that the file
/// gives it, or that somebody else in the process declared in another way.
template <class Value>
std::vector<Value> tag_values(TIFF* tiff, std::uint32_t tag, TIFFDataType type) {
  const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
  if (field == nullptr || TIFFFieldDataType(field) != type || TIFFFieldPassCount(field) == 0) return {};
  const Value* values = nullptr;
  std::size_t count = 0;
  if (TIFFFieldReadCount(field) == TIFF_VARIABLE2) {
    std::uint32_t wide_count = 0;
    if (TIFFGetField(tiff, tag, &wide_count, &values) == 0) return {};
    count = wide_count;
  } else if (TIFFFieldReadCount(field) == TIFF_VARIABLE) {
    std::uint16_t narrow_count = 0;
    if (TIFFGetField(tiff, tag, &narrow_count, &values) == 0) return {};
    count = narrow_count;
  }
  if (values == nullptr || count > kMaxValues) return {};
  return std::vector<Value>(values, values + count);
}

std::string tag_text(TIFF* tiff, std::uint32_t tag) {
  const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
  if (field == nullptr || TIFFFieldDataType(field) != TIFF_ASCII) return {};
  if (TIFFFieldPassCount(field) == 0) {
    const char* text = nullptr;
    return TIFFGetField(tiff, tag, &text) != 0 && text != nullptr ? std::string(text) : std::string();
  }
  const std::vector<char> characters = tag_values<char>(tiff, tag, TIFF_ASCII);
  const std::string text(characters.begin(), characters.end());
  return text.substr(0, text.find('\0'));
}

}  // namespace

std::optional<std::uint16_t> GeoTags::key(std::uint16_t id) const {
  for (std::size_t k = 4; k + 3 < keys.size(); k += 4) {
    if (keys[k] == id && keys[k + 1] == 0) return keys[k + 3];
  }
  return std::nullopt;
}

std::optional<GeoTags> read_geo_tags(const std::filesystem::path& path) {
  if (!is_tiff(path)) return std::nullopt;
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxAllocationBytes);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), ignore_message, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  // Not mapped into memory: a file that shrinks meanwhile would end the process.
  const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpenExt(path.c_str(), "rm", options.get()),
                                                         TIFFClose);
  if (tiff == nullptr) return std::nullopt;
  GeoTags tags;
  tags.pixel_scale = tag_values<double>(tiff.get(), geotiff::kModelPixelScale, TIFF_DOUBLE);
  tags.tie_points = tag_values<double>(tiff.get(), geotiff::kModelTiepoint, TIFF_DOUBLE);
  tags.transformation = tag_values<double>(tiff.get(), geotiff::kModelTransformation, TIFF_DOUBLE);
  tags.keys = tag_values<std::uint16_t>(tiff.get(), geotiff::kGeoKeyDirectory, TIFF_SHORT);
  tags.doubles = tag_values<double>(tiff.get(), geotiff::kGeoDoubleParams, TIFF_DOUBLE);
  tags.ascii = tag_text(tiff.get(), geotiff::kGeoAsciiParams);
  tags.nodata = parse_decimal(tag_text(tiff.get(), geotiff::kGdalNodata));
  return tags;
}

}  // namespace prairie
