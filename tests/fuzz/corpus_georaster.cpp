#include <cmath>
#include <string_view>

#include "maps/georaster/spatial_reference.h"
#include "maps/geotiff_output.h"
#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {
namespace {

constexpr std::string_view kGrid =
    "ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -9999\n"
    "1 2 3 4\n5 -9999 7 8\n9 10 11.5 12\n";

constexpr std::string_view kMosaic = R"(<VRTDataset rasterXSize="16" rasterYSize="8">
<SRS>EPSG:32614</SRS><GeoTransform>0, 1, 0, 8, 0, -1</GeoTransform>
<VRTRasterBand dataType="Float32" band="1"><NoDataValue>-9999</NoDataValue><Scale>0.5</Scale>
<SimpleSource><SourceFilename relativeToVRT="1">a.tif</SourceFilename><SourceBand>1</SourceBand>
<SrcRect xOff="0" yOff="0" xSize="8" ySize="8"/>
<DstRect xOff="0" yOff="0" xSize="8" ySize="8"/></SimpleSource>
<ComplexSource><SourceFilename relativeToVRT="1">a.tif</SourceFilename><SourceBand>1</SourceBand>
<SrcRect xOff="0" yOff="0" xSize="8" ySize="8"/>
<DstRect xOff="8" yOff="0" xSize="8" ySize="8"/>
<ScaleOffset>1</ScaleOffset><ScaleRatio>2</ScaleRatio></ComplexSource>
</VRTRasterBand></VRTDataset>)";

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

std::vector<std::uint8_t> geotiff(const char* system) {
  std::vector<float> heights;
  for (int k = 0; k < 12 * 10; ++k) heights.push_back(300.0f + std::sin(0.3f * static_cast<float>(k)));
  heights[7] = std::nanf("");
  const NodeGrid grid({12, 10, 1.0, {0.0, 0.0}, false}, 1, std::move(heights));
  GeoReference reference;
  reference.west_m = 500'000.0;
  reference.south_m = 4'333'000.0;
  reference.wkt = SpatialReference::of_name(system)->wkt();
  const std::vector<std::byte> bytes = encode_geotiff(grid, &reference);
  const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return {first, first + bytes.size()};
}

}  // namespace

int replay_count() {
  return 10'000;
}

std::vector<Input> make_corpus() {
  struct Seed {
    std::uint8_t name;
    std::vector<std::uint8_t> bytes;
  };
  const std::vector<Seed> seeds{{0, geotiff("EPSG:32614")}, {0, geotiff("EPSG:2264")},
                                {0, geotiff("EPSG:3857")},  {1, bytes_of(kGrid)},
                                {2, bytes_of(kMosaic)},     {3, std::vector<std::uint8_t>(512, 1)}};
  std::vector<Input> corpus;
  for (const Seed& seed : seeds) {
    for (const int choice : {0, 4, 8}) {
      Input input{static_cast<std::uint8_t>(seed.name | choice)};
      input.insert(input.end(), seed.bytes.begin(), seed.bytes.end());
      corpus.push_back(std::move(input));
    }
  }
  return corpus;
}

}  // namespace prairie::fuzz
