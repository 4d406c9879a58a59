#include "maps/georaster/vrt_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <pugixml.hpp>
#include <span>
#include <string_view>
#include <system_error>

#include "files/error.h"
#include "files/input_file.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxVrtBytes = std::uint64_t{16} << 20;
constexpr std::size_t kMaxSources = 4096;
constexpr int kMaxDepth = 4;  // of VRTs in VRTs

// What a mosaic is made of; anything else is a way to other files or to code.
constexpr std::array<std::string_view, 12> kOfDataset{
    "SRS",     "GeoTransform", "Metadata", "VRTRasterBand", "MaskBand",   "BlockXSize",
    "GCPList", "OverviewList", "Overview", "BlockYSize",    "Resampling", "DataAxisToSRSAxisMapping"};
constexpr std::array<std::string_view, 18> kOfBand{"Description",   "UnitType",
                                                   "Offset",        "Scale",
                                                   "NoDataValue",   "HideNoDataValue",
                                                   "CategoryNames", "ColorTable",
                                                   "ColorInterp",   "Metadata",
                                                   "SimpleSource",  "ComplexSource",
                                                   "Histograms",    "GDALRasterAttributeTable",
                                                   "BlockXSize",    "BlockYSize",
                                                   "MaskBand",      "Resampling"};
constexpr std::array<std::string_view, 14> kOfSource{"SourceFilename",
                                                     "SourceBand",
                                                     "SourceProperties",
                                                     "SrcRect",
                                                     "DstRect",
                                                     "NODATA",
                                                     "ScaleOffset",
                                                     "ScaleRatio",
                                                     "LUT",
                                                     "UseMaskBand",
                                                     "ColorTableComponent",
                                                     "Exponent",
                                                     "SrcMin",
                                                     "SrcMax"};

class VrtCheck {
 public:
  explicit VrtCheck(const std::string& field) : field_(field) {}

  void check(const fs::path& vrt, int depth) {
    if (depth > kMaxDepth) fail(vrt, fmt::format("VRTs nested more than {} deep", kMaxDepth), "fewer");
    const std::vector<std::byte> bytes = read_input(vrt, field_, kMaxVrtBytes);
    pugi::xml_document document;
    if (!document.load_buffer(bytes.data(), bytes.size())) fail(vrt, "broken XML", "a VRT as GDAL writes it");
    const pugi::xml_node root = document.document_element();
    if (std::string_view(root.name()) != "VRTDataset") fail(vrt, named(root), "<VRTDataset>");
    if (root.attribute("subClass")) {
      fail(vrt, fmt::format("a VRT of the kind {}", root.attribute("subClass").value()),
           "a mosaic as gdalbuildvrt writes it, or the raster itself: gdal_translate IN.vrt OUT.tif");
    }
    for (const pugi::xml_node child : elements(vrt, root, kOfDataset)) {
      if (std::string_view(child.name()) == "VRTRasterBand") check_band(vrt, child, depth);
      if (std::string_view(child.name()) == "MaskBand") check_mask(vrt, child, depth);
    }
  }

  std::vector<fs::path> take() { return std::move(files_); }

 private:
  [[noreturn]] void fail(const fs::path& vrt, const std::string& found, const std::string& expected) const {
    throw BadInput(vrt.string(), field_, found, expected);
  }

  static std::string named(const pugi::xml_node& node) { return fmt::format("<{}>", node.name()); }

  std::vector<pugi::xml_node> elements(const fs::path& vrt, const pugi::xml_node& parent,
                                       std::span<const std::string_view> known) const {
    std::vector<pugi::xml_node> result;
    for (const pugi::xml_node child : parent.children()) {
      if (child.type() != pugi::node_element) continue;
      if (std::ranges::find(known, std::string_view(child.name())) == known.end()) {
        fail(vrt, fmt::format("{} in {}", named(child), named(parent)),
             "a mosaic of SimpleSource and ComplexSource, or the raster itself: gdal_translate IN.vrt "
             "OUT.tif");
      }
      result.push_back(child);
    }
    return result;
  }

  void check_mask(const fs::path& vrt, const pugi::xml_node& mask, int depth) {
    constexpr std::array<std::string_view, 1> kOfMask{"VRTRasterBand"};
    for (const pugi::xml_node band : elements(vrt, mask, kOfMask)) check_band(vrt, band, depth);
  }

  void check_band(const fs::path& vrt, const pugi::xml_node& band, int depth) {
    if (band.attribute("subClass"))
      fail(vrt, fmt::format("a band of the kind {}", band.attribute("subClass").value()), "a plain band");
    for (const pugi::xml_node child : elements(vrt, band, kOfBand)) {
      const std::string_view name = child.name();
      if (name == "MaskBand") check_mask(vrt, child, depth);
      if (name != "SimpleSource" && name != "ComplexSource") continue;
      for (const pugi::xml_node part : elements(vrt, child, kOfSource)) {
        if (std::string_view(part.name()) == "SourceFilename") check_source(vrt, part, depth);
      }
    }
  }

  void check_source(const fs::path& vrt, const pugi::xml_node& name, int depth) {
    const std::string text = name.child_value();
    const bool is_relative = name.attribute("relativeToVRT").as_int() == 1;
    const fs::path folder = vrt.has_parent_path() ? vrt.parent_path() : fs::path(".");
    const fs::path named_file = is_relative ? folder / text : fs::path(text);
    std::error_code error;
    const fs::path home = fs::canonical(folder, error);
    const fs::path file = fs::canonical(named_file, error);
    // GDAL takes names that begin with /vsi or hold a colon for other things than files.
    const bool is_plain = !text.empty() && !text.starts_with("/vsi") && text.find(':') == std::string::npos &&
                          text.find('<') == std::string::npos;
    if (error || !is_plain || !fs::is_regular_file(file, error)) {
      fail(vrt, fmt::format("the source {:.200}", text), "a file that is there");
    }
    const auto [end_of_home, rest] = std::ranges::mismatch(home, file);
    if (end_of_home != home.end())
      fail(vrt, fmt::format("the source {:.200}", text), "a file in the folder of the VRT, or below it");
    if (std::ranges::find(files_, file) != files_.end()) return;
    if (files_.size() >= kMaxSources)
      fail(vrt, fmt::format("more than {} sources", kMaxSources), "fewer files");
    files_.push_back(file);
    if (is_vrt(file)) check(file, depth + 1);
  }

  const std::string& field_;
  std::vector<fs::path> files_;
};

}  // namespace

bool is_vrt(const fs::path& path) {
  std::array<char, 512> head{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), head.size());
  return std::string_view(head.data(), static_cast<std::size_t>(stream.gcount())).find("<VRTDataset") !=
         std::string_view::npos;
}

std::vector<fs::path> checked_vrt_sources(const fs::path& vrt, const std::string& field) {
  VrtCheck check(field);
  check.check(vrt, 0);
  return check.take();
}

}  // namespace prairie
