#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <memory>
#include <string>

#include "maps/georaster/spatial_reference.h"
#include "maps/geotiff_output.h"
#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {
namespace {

constexpr int kSide = 24;

Input encoded(const std::string& format, int channels, OIIO::TypeDesc type, const char* compression,
              int tile) {
  OIIO::ImageSpec spec(kSide, kSide, channels, type);
  if (compression != nullptr) spec.attribute("compression", compression);
  if (tile > 0) spec.tile_width = spec.tile_height = tile;
  std::vector<float> pixels;
  for (int k = 0; k < kSide * kSide * channels; ++k)
    pixels.push_back(0.5f + 0.5f * std::sin(0.1f * static_cast<float>(k)));
  OIIO::Filesystem::IOVecOutput memory;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (output == nullptr || !output->set_ioproxy(&memory) || !output->open("x." + format, spec)) return {};
  output->write_image(OIIO::TypeDesc::FLOAT, pixels.data());
  output->close();
  return memory.buffer();
}

}  // namespace

int replay_count() {
  return 3000;
}

std::vector<Input> make_corpus() {
  using OIIO::TypeDesc;
  std::vector<Input> files;
  for (const TypeDesc type : {TypeDesc::UINT8, TypeDesc::UINT16}) {
    for (const int channels : {1, 3, 4}) files.push_back(encoded("png", channels, type, nullptr, 0));
  }
  for (const TypeDesc type : {TypeDesc::UINT8, TypeDesc::INT16, TypeDesc::UINT32, TypeDesc::FLOAT}) {
    for (const char* compression : {"none", "lzw", "zip", "packbits"}) {
      files.push_back(encoded("tif", 1, type, compression, 0));
    }
    files.push_back(encoded("tif", 3, type, "zip", 16));
  }
  for (const TypeDesc type : {TypeDesc::HALF, TypeDesc::FLOAT}) {
    for (const char* compression : {"none", "rle", "zip", "piz", "pxr24", "b44"}) {
      files.push_back(encoded("exr", 1, type, compression, 0));
    }
    files.push_back(encoded("exr", 3, type, "zips", 16));
  }
  files.push_back(encoded("bmp", 3, TypeDesc::UINT8, nullptr, 0));
  files.push_back(encoded("tga", 1, TypeDesc::UINT8, nullptr, 0));
  files.push_back(encoded("jpg", 3, TypeDesc::UINT8, nullptr, 0));

  GeoReference reference;
  reference.wkt = SpatialReference::of_name("EPSG:32614")->wkt();
  std::vector<float> heights(kSide * kSide, 300.0f);
  heights[7] = std::nanf("");
  const NodeGrid grid({kSide, kSide, 1.0, {0.0, 0.0}, false}, 1, std::move(heights));
  const std::vector<std::byte> geotiff = encode_geotiff(grid, &reference);
  const std::uint8_t* bytes = reinterpret_cast<const std::uint8_t*>(geotiff.data());
  files.emplace_back(bytes, bytes + geotiff.size());

  std::vector<Input> corpus;
  for (Input& file : files) {
    if (file.empty()) continue;
    // Asked for as heights and as density, with a spacing and a range, in memory and in a temporary file.
    for (const Input::value_type choice : Input{0x14, 0x15, 0x54}) {
      Input input{choice};
      input.insert(input.end(), file.begin(), file.end());
      corpus.push_back(std::move(input));
    }
  }
  return corpus;
}

}  // namespace prairie::fuzz
