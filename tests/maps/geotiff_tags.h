// The TIFF tags and keys of GeoTIFF (OGC 19-008r4) that say where a raster lies on Earth.
#pragma once

#include <cstdint>

namespace prairie::geotiff {

inline constexpr std::uint32_t kModelPixelScale = 33550;
inline constexpr std::uint32_t kModelTiepoint = 33922;
inline constexpr std::uint32_t kModelTransformation = 34264;
inline constexpr std::uint32_t kGeoKeyDirectory = 34735;
inline constexpr std::uint32_t kGeoDoubleParams = 34736;
inline constexpr std::uint32_t kGeoAsciiParams = 34737;
inline constexpr std::uint32_t kGdalNodata = 42113;  // GDAL's own, a decimal number as text

inline constexpr std::uint16_t kModelTypeKey = 1024;
inline constexpr std::uint16_t kRasterTypeKey = 1025;
inline constexpr std::uint16_t kProjectedCrsKey = 3072;  // an EPSG code
inline constexpr std::uint16_t kProjectedLinearUnitsKey = 3076;

inline constexpr std::uint16_t kModelTypeGeographic = 2;
inline constexpr std::uint16_t kRasterPixelIsArea = 1;
inline constexpr std::uint16_t kRasterPixelIsPoint = 2;
inline constexpr std::uint16_t kLinearUnitMetre = 9001;

}  // namespace prairie::geotiff
