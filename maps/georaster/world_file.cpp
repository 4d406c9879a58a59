#include "maps/georaster/world_file.h"

#include <gdal.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "maps/georaster/gdal_session.h"

namespace prairie {

std::optional<MapFromPixel> world_file_place(const std::filesystem::path& image) {
  GdalSession session;
  MapFromPixel place{};
  for (const char* extension : {static_cast<const char*>(nullptr), "wld"}) {
    if (GDALReadWorldFile(image.c_str(), extension, place.data()) != 0) return place;
  }
  return std::nullopt;
}

std::optional<SpatialReference> projection_file_reference(const std::filesystem::path& image) {
  constexpr std::streamsize kMostBytes = 1 << 16;
  std::filesystem::path path = image;
  std::ifstream stream(path.replace_extension(".prj"), std::ios::binary);
  std::string text(static_cast<std::size_t>(kMostBytes), '\0');
  stream.read(text.data(), kMostBytes);
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return SpatialReference::of_wkt(text);
}

}  // namespace prairie
