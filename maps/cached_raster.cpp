#include "maps/cached_raster.h"

#include <OpenImageIO/imagecache.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "files/error.h"

namespace prairie {
namespace {

constexpr int kTilePixels = 256;
constexpr double kBytesPerMB = 1024.0 * 1024.0;

class CachedRaster : public NodeSource {
 public:
  CachedRaster(const CachedRasterSpec& spec, const ValueMapping& mapping, std::uint64_t budget_bytes)
      : spec_(spec),
        mapping_(mapping),
        file_(spec.map.file.string()),
        cache_(OIIO::ImageCache::create(false),
               [](OIIO::ImageCache* c) { OIIO::ImageCache::destroy(c, true); }) {
    cache_->attribute("autotile", kTilePixels);
    cache_->attribute("unassociatedalpha", 1);
    cache_->attribute("max_memory_MB", static_cast<float>(static_cast<double>(budget_bytes) / kBytesPerMB));
    cache_->attribute("max_open_files", 4);
    cache_->attribute("statistics:level", 0);
  }

  void read(const NodeRect& rect, std::span<float> out) const override {
    const std::size_t row_samples =
        static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(spec_.channels.count);
    const std::size_t row_values =
        static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(spec_.value_channels);
    std::vector<float> samples(row_samples * static_cast<std::size_t>(rect.rows));
    const OIIO::ImageSpec& image = spec_.image;
    const int x = image.x + rect.column;
    const int top = image.y + image.height - rect.row - rect.rows;  // the file's first row is north
    if (!cache_->get_pixels(file_, 0, 0, x, x + rect.columns, top, top + rect.rows, image.z, image.z + 1,
                            spec_.channels.first, spec_.channels.first + spec_.channels.count,
                            OIIO::TypeDesc::FLOAT, samples.data())) {
      throw BadInput(spec_.map.file.string(), spec_.map.field, cache_->geterror(),
                     "the file as it was when it was opened");
    }
    for (std::size_t j = 0; j < static_cast<std::size_t>(rect.rows); ++j) {
      const std::size_t from = static_cast<std::size_t>(rect.rows) - 1 - j;
      mapping_.map_pixels(std::span<const float>(samples).subspan(from * row_samples, row_samples),
                          spec_.channels.count, spec_.value_channels, out.subspan(j * row_values, row_values),
                          nullptr);
    }
  }

 private:
  CachedRasterSpec spec_;
  ValueMapping mapping_;
  OIIO::ustring file_;
  std::shared_ptr<OIIO::ImageCache> cache_;
};

}  // namespace

std::shared_ptr<const NodeSource> make_cached_raster(const CachedRasterSpec& spec,
                                                     const ValueMapping& mapping,
                                                     std::uint64_t budget_bytes) {
  return std::make_shared<CachedRaster>(spec, mapping, budget_bytes);
}

}  // namespace prairie
