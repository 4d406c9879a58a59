#include "maps/georaster/georaster.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal.h>
#include <gdal_utils.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "files/error.h"
#include "files/input_file.h"
#include "files/quiet_stderr.h"
#include "maps/georaster/gdal_session.h"
#include "maps/georaster/vrt_sources.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 1'000'000;
constexpr int kMaxBands = 512;  // hyperspectral ones have hundreds
constexpr std::uint64_t kMaxBlockBytes = std::uint64_t{256} << 20;
constexpr std::uint64_t kMaxExpansion = 1100;  // as for pictures (pictures/raster_file.cpp)
constexpr std::uint64_t kHarmlessBytes = std::uint64_t{64} << 20;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr const char* kWholeRaster = "a complete GeoTIFF, ESRI ASCII grid, SRTM .hgt or VRT";
constexpr const char* kToFloat = "integers or floating-point numbers; gdal_translate -ot Float32 IN OUT.tif";

struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using OpenDataset = std::unique_ptr<void, CloseDataset>;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string read_head(const fs::path& path) {
  std::string head(1024, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return head;
}

bool is_ascii_grid(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  const std::string word = lower(std::string(head.substr(first, 5)));
  return word == "ncols" || word == "nrows" || word.starts_with("xll") || word.starts_with("dx");
}

OpenDataset open_dataset(const fs::path& path) {
  return OpenDataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_INTERNAL,
                                raster_drivers(), nullptr, nullptr));
}

std::string metadata(void* object, const char* name, const char* domain) {
  const char* value = GDALGetMetadataItem(object, name, domain);
  return value != nullptr ? value : "";
}

/// bits and largest value; bits of 0 where the type is none that a map is made of.
SampleType sample_type_of(GDALRasterBandH band) {
  const std::string bits_text = metadata(band, "NBITS", "IMAGE_STRUCTURE");
  const int stored_bits = bits_text.empty() ? 0 : std::atoi(bits_text.c_str());
  const bool is_narrow = stored_bits > 0 && stored_bits < 32;
  const auto narrowed = [&](int bits, double largest) {
    return is_narrow && stored_bits < bits ? SampleType{bits, std::ldexp(1.0, stored_bits) - 1.0}
                                           : SampleType{bits, largest};
  };
  switch (GDALGetRasterDataType(band)) {
    case GDT_Byte:
      if (metadata(band, "PIXELTYPE", "IMAGE_STRUCTURE") == "SIGNEDBYTE") return {8, 127.0};
      return narrowed(8, 255.0);
    case GDT_UInt16:
      return narrowed(16, 65535.0);
    case GDT_Int16:
      return {16, 32767.0};
    case GDT_UInt32:
      return narrowed(32, 4294967295.0);
    case GDT_Int32:
      return {32, 2147483647.0};
    case GDT_UInt64:
      return {64, 18446744073709551615.0};
    case GDT_Int64:
      return {64, 9223372036854775807.0};
    case GDT_Float32:
      return {stored_bits == 16 ? 16 : 32, 0.0};
    case GDT_Float64:
      return {64, 0.0};
    default:
      return {0, 0.0};
  }
}

std::string name_of(GDALRasterBandH band) {
  const std::string description = GDALGetDescription(band);
  if (!description.empty()) return description;
  switch (GDALGetRasterColorInterpretation(band)) {
    case GCI_RedBand:
      return "R";
    case GCI_GreenBand:
      return "G";
    case GCI_BlueBand:
      return "B";
    case GCI_AlphaBand:
      return "A";
    default:
      return "";
  }
}

std::vector<std::array<std::uint8_t, 4>> palette_of(GDALRasterBandH band) {
  std::vector<std::array<std::uint8_t, 4>> palette;
  GDALColorTableH table = GDALGetRasterColorTable(band);
  if (table == nullptr || GDALGetRasterColorInterpretation(band) != GCI_PaletteIndex) return palette;
  const auto byte = [](short value) { return static_cast<std::uint8_t>(std::clamp<int>(value, 0, 255)); };
  for (int k = 0; k < GDALGetColorEntryCount(table); ++k) {
    const GDALColorEntry* entry = GDALGetColorEntry(table, k);
    palette.push_back({byte(entry->c1), byte(entry->c2), byte(entry->c3), byte(entry->c4)});
  }
  return palette;
}

Band band_of(GDALRasterBandH handle) {
  Band band;
  band.name = name_of(handle);
  band.type = sample_type_of(handle);
  int is_set = 0;
  const GDALDataType type = GDALGetRasterDataType(handle);
  if (type == GDT_Int64) {
    const double nodata = static_cast<double>(GDALGetRasterNoDataValueAsInt64(handle, &is_set));
    if (is_set != 0) band.nodata = nodata;
  } else if (type == GDT_UInt64) {
    const double nodata = static_cast<double>(GDALGetRasterNoDataValueAsUInt64(handle, &is_set));
    if (is_set != 0) band.nodata = nodata;
  } else {
    const double nodata = GDALGetRasterNoDataValue(handle, &is_set);
    if (is_set != 0) band.nodata = nodata;
  }
  int has_scale = 0, has_offset = 0;
  const double scale = GDALGetRasterScale(handle, &has_scale);
  const double offset = GDALGetRasterOffset(handle, &has_offset);
  if (has_scale != 0) band.scale = scale;
  if (has_offset != 0) band.offset = offset;
  band.has_scale = band.scale != 1.0 || band.offset != 0.0;
  band.unit = GDALGetRasterUnitType(handle);
  band.is_alpha = GDALGetRasterColorInterpretation(handle) == GCI_AlphaBand;
  band.is_inverted = metadata(handle, "MINISWHITE", "IMAGE_STRUCTURE") == "YES";
  band.palette = palette_of(handle);
  return band;
}

/// The file and what lies beside it and decides which of its values hold.
std::vector<fs::path> with_sidecars(const std::vector<fs::path>& files) {
  std::vector<fs::path> result;
  for (const fs::path& file : files) {
    result.push_back(file);
    for (const char* extension : {".msk", ".aux.xml"}) {
      fs::path sidecar = file;
      sidecar += extension;
      std::error_code ignored;
      if (fs::is_regular_file(sidecar, ignored)) result.push_back(std::move(sidecar));
    }
  }
  return result;
}

}  // namespace

struct Georaster::Dataset {
  std::vector<OpenDataset> parts;  // of a mosaic
  OpenDataset whole;
};

bool is_georaster(const fs::path& path) {
  using namespace std::string_view_literals;
  const std::string head = read_head(path);
  for (const std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
    if (head.starts_with(magic)) return true;
  }
  return is_ascii_grid(head) || is_vrt(path) || lower(path.extension().string()) == ".hgt";
}

Georaster::Georaster(const std::vector<fs::path>& files, const std::string& field)
    : path_(files.at(0)), field_(field), dataset_(std::make_unique<Dataset>()) {
  GdalSession session;
  const QuietStderr quiet;  // of PROJ, which prints some of its complaints
  open(files);
  check_claims();
  look_at_bands();
  look_at_place();
}

Georaster::~Georaster() {
  GdalSession session;
  dataset_.reset();
}

void Georaster::fail(const std::string& found, const std::string& expected) const {
  throw BadInput(path_.string(), field_, found.empty() ? "something unreadable" : found, expected);
}

void Georaster::open(const std::vector<fs::path>& files) {
  GdalSession session;
  std::vector<fs::path> all;
  for (const fs::path& file : files) {
    path_ = file;
    all.push_back(file);
    if (is_vrt(file)) std::ranges::copy(checked_vrt_sources(file, field_), std::back_inserter(all));
    OpenDataset part = open_dataset(file);
    if (part == nullptr) fail(session.take_error(), kWholeRaster);
    dataset_->parts.push_back(std::move(part));
  }
  files_ = with_sidecars(all);
  path_ = files.front();
  if (files.size() == 1) {
    dataset_->whole = std::move(dataset_->parts.front());
    dataset_->parts.clear();
  } else {
    join(files);
  }
  columns_ = GDALGetRasterXSize(dataset_->whole.get());
  rows_ = GDALGetRasterYSize(dataset_->whole.get());
}

void Georaster::join(const std::vector<fs::path>& files) {
  GdalSession session;
  const std::string first_wkt = GDALGetProjectionRef(dataset_->parts.front().get());
  const auto first_reference = SpatialReference::of_wkt(first_wkt);
  std::vector<GDALDatasetH> handles;
  for (std::size_t k = 0; k < files.size(); ++k) {
    path_ = files[k];
    GDALDatasetH part = dataset_->parts[k].get();
    const auto reference = SpatialReference::of_wkt(GDALGetProjectionRef(part));
    MapFromPixel place{};
    if (GDALGetGeoTransform(part, place.data()) != CE_None)
      fail("no geo-reference", "one, as each raster of a mosaic needs it");
    if (reference.has_value() != first_reference.has_value() ||
        (reference && !reference->has_plane_of(*first_reference))) {
      fail(fmt::format("the coordinate system {}", reference ? reference->name() : "of nobody knows where"),
           fmt::format("that of {}, {}; gdalwarp -t_srs brings rasters into one", files.front().string(),
                       first_reference ? first_reference->name() : "none"));
    }
    handles.push_back(part);
  }
  path_ = files.front();
  char* arguments[] = {nullptr};
  GDALBuildVRTOptions* options = GDALBuildVRTOptionsNew(arguments, nullptr);
  int usage_error = 0;
  dataset_->whole.reset(
      GDALBuildVRT("", static_cast<int>(handles.size()), handles.data(), nullptr, options, &usage_error));
  GDALBuildVRTOptionsFree(options);
  if (dataset_->whole == nullptr) fail(session.take_error(), "rasters that a mosaic can be made of");
}

void Georaster::check_claims() const {
  GDALDatasetH dataset = dataset_->whole.get();
  const int count = GDALGetRasterCount(dataset);
  if (columns_ < 1 || rows_ < 1 || columns_ > kMaxSide || rows_ > kMaxSide)
    fail(fmt::format("a claim of {} × {} pixels", columns_, rows_),
         fmt::format("1 to {} pixels a side", kMaxSide));
  if (count < 1 || count > kMaxBands)
    fail(fmt::format("{} bands", count), fmt::format("1 to {} bands", kMaxBands));
  std::uint64_t held_bytes = 0;
  for (const fs::path& file : files_) {
    std::error_code ignored;
    const std::uintmax_t bytes = fs::file_size(file, ignored);
    if (!ignored) held_bytes += bytes;
  }
  GDALRasterBandH first = GDALGetRasterBand(dataset, 1);
  const auto sample_bytes =
      static_cast<std::uint64_t>(GDALGetDataTypeSizeBytes(GDALGetRasterDataType(first)));
  const std::uint64_t pixels = static_cast<std::uint64_t>(columns_) * static_cast<std::uint64_t>(rows_);
  const std::uint64_t claimed_bytes = pixels * sample_bytes * static_cast<std::uint64_t>(count);
  if (claimed_bytes > kHarmlessBytes && claimed_bytes / kMaxExpansion > held_bytes) {
    fail(fmt::format("a claim of {} × {} pixels ({} MB) in {} bytes", columns_, rows_, claimed_bytes >> 20,
                     held_bytes),
         "a file that can hold the pixels it claims");
  }
  int block_columns = 0, block_rows = 0;
  GDALGetBlockSize(first, &block_columns, &block_rows);
  if (block_columns < 1 || block_rows < 1 ||
      static_cast<std::uint64_t>(block_columns) * static_cast<std::uint64_t>(block_rows) * sample_bytes *
              static_cast<std::uint64_t>(count) >
          kMaxBlockBytes) {
    fail(fmt::format("blocks of {} × {} pixels", block_columns, block_rows),
         fmt::format("blocks of at most {} MB; gdal_translate -co TILED=YES IN OUT.tif",
                     kMaxBlockBytes >> 20));
  }
}

void Georaster::look_at_bands() {
  GDALDatasetH dataset = dataset_->whole.get();
  int block_columns = 0;
  GDALGetBlockSize(GDALGetRasterBand(dataset, 1), &block_columns, &block_rows_);
  for (int k = 1; k <= GDALGetRasterCount(dataset); ++k) {
    GDALRasterBandH handle = GDALGetRasterBand(dataset, k);
    bands_.push_back(band_of(handle));
    if (bands_.back().type.bits == 0)
      fail(fmt::format("values of the type {}", GDALGetDataTypeName(GDALGetRasterDataType(handle))),
           kToFloat);
  }
}

void Georaster::look_at_place() {
  GDALDatasetH dataset = dataset_->whole.get();
  MapFromPixel place{};
  if (GDALGetGeoTransform(dataset, place.data()) == CE_None) map_from_pixel_ = place;
  has_control_points_ = !map_from_pixel_ && GDALGetGCPCount(dataset) > 0;
  reference_ = SpatialReference::of_wkt(GDALGetProjectionRef(dataset));
}

void Georaster::read(const PixelRect& rect, int band, std::span<double> out) const {
  GdalSession session;
  GDALRasterBandH handle = GDALGetRasterBand(dataset_->whole.get(), band + 1);
  const auto read_band = [&](GDALRasterBandH from, void* to, GDALDataType type) {
    const CPLErr result = GDALRasterIO(from, GF_Read, rect.x, rect.y, rect.width, rect.height, to, rect.width,
                                       rect.height, type, 0, 0);
    const std::string error = session.take_error();
    if (result != CE_None || !error.empty()) fail(error, kWholeRaster);
  };
  read_band(handle, out.data(), GDT_Float64);
  if (const Band& own = bands_[static_cast<std::size_t>(band)]; own.is_inverted) {
    for (double& value : out) value = own.type.largest - value;
  }
  const int flags = GDALGetMaskFlags(handle);
  if ((flags & (GMF_ALL_VALID | GMF_NODATA)) != 0) return;
  // What painters put into alpha is theirs; of a raster with a place it says where there is ground.
  if ((flags & GMF_ALPHA) != 0 && !map_from_pixel_) return;
  std::vector<std::uint8_t> valid(out.size());
  read_band(GDALGetMaskBand(handle), valid.data(), GDT_Byte);
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (valid[k] == 0) out[k] = kNaN;
  }
}

}  // namespace prairie
