// A georeferenced raster, or a mosaic of several, opened by GDAL without trusting it: what its values are
// (type, scale and offset, unit, nodata, masks), where its pixels lie on Earth, and the values themselves.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "maps/georaster/spatial_reference.h"
#include "pictures/pixel_rect.h"
#include "pictures/raster_file.h"

namespace prairie {

/// One band of a raster; its stored values v mean scale · v + offset, in `unit`.
struct Band {
  std::string name;  // its description or its colour (R, G, B, A); empty if it has neither
  SampleType type;
  std::optional<double> nodata;
  bool has_scale = false;
  double scale = 1.0;
  double offset = 0.0;
  std::string unit;  // as the file writes it: "m", "ft", …
  bool is_alpha = false;
  bool is_inverted = false;  // the largest value is black
  std::vector<std::array<std::uint8_t, 4>> palette;
};

/// map = (g0 + g1 x + g2 y, g3 + g4 x + g5 y) of pixel coordinates (x, y) counted from the corner of the
/// first pixel.
using MapFromPixel = std::array<double, 6>;

/// Whether GDAL reads the file, by its first bytes or its name: TIFF, VRT, ESRI ASCII grid or SRTM .hgt.
bool is_georaster(const std::filesystem::path& path);

class Georaster {
 public:
  /// Several files are laid side by side, later ones over earlier ones. Throws BadInput (for `field`) where
  /// a file cannot be opened, claims more than the limits or than its bytes can hold, or where several do not
  /// go together.
  Georaster(const std::vector<std::filesystem::path>& files, const std::string& field);
  ~Georaster();

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const std::vector<Band>& bands() const { return bands_; }
  const std::optional<MapFromPixel>& map_from_pixel() const { return map_from_pixel_; }
  const std::optional<SpatialReference>& reference() const { return reference_; }
  /// Control points instead of a place for each pixel.
  bool has_control_points() const { return has_control_points_; }
  /// All files that were opened for it, the named ones and those of VRTs; sidecars that carry validity too.
  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// Rows that are best read together.
  int block_rows() const { return block_rows_; }

  /// Stored values of `band` in `rect` (inside the raster), rows from the file's first; NaN where a mask or,
  /// of a raster with a place, an alpha of 0 says that there is no value. Throws BadInput where the file
  /// breaks off.
  void read(const PixelRect& rect, int band, std::span<double> out) const;

 private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;
  void open(const std::vector<std::filesystem::path>& files);
  void join(const std::vector<std::filesystem::path>& files);
  void check_claims() const;
  void look_at_bands();
  void look_at_place();

  struct Dataset;
  std::filesystem::path path_;
  std::string field_;
  std::unique_ptr<Dataset> dataset_;
  int columns_ = 0;
  int rows_ = 0;
  int block_rows_ = 1;
  std::vector<Band> bands_;
  std::optional<MapFromPixel> map_from_pixel_;
  std::optional<SpatialReference> reference_;
  bool has_control_points_ = false;
  std::vector<std::filesystem::path> files_;
};

}  // namespace prairie
