#include "app/outputs/blade_table.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <glm/vec3.hpp>

#include "generator/blade_identity.h"
#include "generator/cell_table.h"

namespace prairie {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is written in the order of this machine");

struct FloatColumn {
  const char* name;
  float (*value)(const Blade&);
};

// What the seed gave each blade, in the order of struct Blade; the columns of both formats.
constexpr std::array<FloatColumn, 12> kAttributes{{
    {"height_m", [](const Blade& blade) { return blade.height_m; }},
    {"width_m", [](const Blade& blade) { return blade.width_m; }},
    {"azimuth_rad", [](const Blade& blade) { return blade.azimuth_rad; }},
    {"tilt_rad", [](const Blade& blade) { return blade.tilt_rad; }},
    {"curvature_rad", [](const Blade& blade) { return blade.curvature_rad; }},
    {"lean_east", [](const Blade& blade) { return blade.lean.x; }},
    {"lean_north", [](const Blade& blade) { return blade.lean.y; }},
    {"hue", [](const Blade& blade) { return blade.hue; }},
    {"dryness", [](const Blade& blade) { return blade.dryness; }},
    {"stiffness", [](const Blade& blade) { return blade.stiffness; }},
    {"mass_g", [](const Blade& blade) { return blade.mass_g; }},
    {"phase_rad", [](const Blade& blade) { return blade.phase_rad; }},
}};

template <typename Value>
void append_bytes(std::string& bytes, Value value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  bytes.append(raw.data(), raw.size());
}

std::string csv_rows(const Meadow& meadow, TileId tile, std::span<const Blade> blades) {
  const glm::dvec3 origin_m(tile_origin_m(meadow, tile), tile_base_m(meadow, tile));
  std::string rows;
  for (const Blade& blade : blades) {
    const BladeIdentity identity = identity_of(blade);
    const glm::dvec3 root_m = origin_m + glm::dvec3(blade.root_m, blade.ground_m);
    rows += fmt::format("{},{},{},{},{},{:.6f},{:.6f},{:.6f}", tile.i, tile.j,
                        meadow.species[identity.species].species.name, identity.cell, identity.index,
                        root_m.x, root_m.y, root_m.z);
    for (const FloatColumn& column : kAttributes) {
      rows += fmt::format(",{}", column.value(blade));
    }
    rows += '\n';
  }
  return rows;
}

std::string ply_rows(const Meadow& meadow, TileId tile, std::span<const Blade> blades) {
  const glm::dvec3 origin_m(tile_origin_m(meadow, tile), tile_base_m(meadow, tile));
  std::string bytes;
  for (const Blade& blade : blades) {
    const BladeIdentity identity = identity_of(blade);
    const glm::dvec3 root_m = origin_m + glm::dvec3(blade.root_m, blade.ground_m);
    append_bytes(bytes, root_m.x);
    append_bytes(bytes, root_m.y);
    append_bytes(bytes, root_m.z);
    append_bytes(bytes, tile.i);
    append_bytes(bytes, tile.j);
    append_bytes(bytes, static_cast<std::uint8_t>(identity.species));
    append_bytes(bytes, static_cast<std::uint8_t>(identity.cell));
    append_bytes(bytes, identity.index);
    for (const FloatColumn& column : kAttributes) append_bytes(bytes, column.value(blade));
  }
  return bytes;
}

}  // namespace

std::string blade_table_header(BladeTableFormat format, const Meadow& meadow, std::uint64_t blade_count) {
  if (format == BladeTableFormat::kCsv) {
    std::string header = "tile_i,tile_j,species,cell,index,x_m,y_m,z_m";
    for (const FloatColumn& column : kAttributes) header += fmt::format(",{}", column.name);
    return header + '\n';
  }
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  for (std::size_t s = 0; s < meadow.species.size(); ++s) {
    header += fmt::format("comment species {} {}\n", s, meadow.species[s].species.name);
  }
  header += fmt::format("element vertex {}\n", blade_count);
  for (const char* name : {"x", "y", "z"}) header += fmt::format("property double {}\n", name);
  header += "property int tile_i\nproperty int tile_j\n";
  header += "property uchar species\nproperty uchar cell\nproperty uint index\n";
  for (const FloatColumn& column : kAttributes) header += fmt::format("property float {}\n", column.name);
  return header + "end_header\n";
}

std::string blade_rows(BladeTableFormat format, const Meadow& meadow, TileId tile,
                       std::span<const Blade> blades) {
  return format == BladeTableFormat::kCsv ? csv_rows(meadow, tile, blades) : ply_rows(meadow, tile, blades);
}

}  // namespace prairie
