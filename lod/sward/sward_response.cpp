#include "lod/sward/sward_response.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "lod/sward/sward_sample.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr int kElevations = SwardResponse::kElevations;
constexpr int kAzimuths = SwardResponse::kAzimuths;
constexpr int kDepths = SwardResponse::kDepths;

// Coordinates of the tables. Elevations crowd at grazing angles, where the view changes fastest.
const double kLowestSine{kSwardLowestSine};
// Optical depth τ lies at log(1 + τ), scaled so that the last node is the deepest: a fine step of colour for
// each doubling, since the deeper a sward is, the higher and thinner is the layer of it that one sees.
const double kDeepest{kSwardDeepest};
constexpr double kThinnest = 1e-6;  // in place of 0, where weights would vanish

double sine_at(int elevation) {
  const double lowest = std::sqrt(kLowestSine);
  const double root = lowest + (1.0 - lowest) * elevation / (kElevations - 1);
  return root * root;
}

double depth_at(int depth) {
  return std::max(std::expm1(std::log1p(kDeepest) * depth / (kDepths - 1)), kThinnest);
}

// Slices of the sward, from the top; the same for all layers. They hold less leaf area the higher they are.
constexpr int kSlices = 48;
constexpr double kTopShare = 0.003;

// What an element's light amounts to per area seen: light from all sides and, times the cosine, on the lit
// and on the far side. Lanes 0…2 are the free blades' rgb, 3…5 the shaded ones', 6 the contour's strength, 7
// counts the area itself.
constexpr int kLanes = 8;
using Lanes = std::array<float, kLanes>;
struct Lit {
  Lanes all_round, front, back;
};

struct Sheet {
  double share;  // blades per m² of the mix's leaf area
  SwardElements elements;
  std::vector<Lit> lit;
  std::array<std::size_t, kSlices + 1> slice_begin;  // into elements
};

void set(Lanes& lanes, int first, glm::vec3 color) {
  for (int channel = 0; channel < 3; ++channel)
    lanes[static_cast<std::size_t>(first + channel)] = color[channel];
}

// blade_radiance is linear in what falls on each side, so that it is asked once per element, not per view.
Lit lit_at(const SpeciesParams& species, const LightParams& light, glm::vec3 albedo, float place) {
  Kernels kernels;
  Lit lit{};
  for (const bool shaded : {false, true}) {
    const float shade = shaded ? 1.0f : 0.0f;
    const auto radiance = [&](float n_dot_l) {
      return kernels.blade_radiance(light, albedo, species.transmission, 0.0f, place, shade, n_dot_l, 1.0f);
    };
    const glm::vec3 all_round = radiance(0.0f);
    const int first = shaded ? 3 : 0;
    set(lit.all_round, first, all_round);
    set(lit.front, first, radiance(1.0f) - all_round);
    set(lit.back, first, radiance(-1.0f) - all_round);
  }
  LightParams white = light;
  white.horizon_radiance = glm::vec3(1.0f);
  lit.all_round[6] = kernels
                         .blade_radiance(white, glm::vec3(0.0f), species.transmission, species.specular,
                                         place, 0.0f, 0.0f, 0.0f)
                         .x;
  lit.all_round[7] = 1.0f;
  return lit;
}

void add(Lanes& sum, const Lanes& lanes, float share) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) sum[lane] += share * lanes[lane];
}

Lit lit_element(const SpeciesParams& species, const LightParams& light, const SwardElements& elements,
                std::size_t n) {
  const float place = elements.place[n];
  return lit_at(species, light, Kernels{}.mixed(elements.root_albedo[n], elements.tip_albedo[n], place),
                place);
}

std::vector<Sheet> sheets_of(std::span<const SwardLayer> layers, const LightParams& light) {
  std::vector<Sheet> sheets(layers.size());
  oneapi::tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t s) {
    const SpeciesParams& species = *layers[s].species;
    Sheet& sheet = sheets[s];
    sheet.elements = sward_elements(species);
    for (std::size_t n = 0; n < sheet.elements.size(); ++n)
      sheet.lit.push_back(lit_element(species, light, sheet.elements, n));
  });
  double total_area = 0.0;
  for (std::size_t s = 0; s < layers.size(); ++s) {
    for (const float area_m2 : sheets[s].elements.area_m2)
      total_area += layers[s].density_per_m2 * static_cast<double>(area_m2);
  }
  assert(total_area > 0.0);
  for (std::size_t s = 0; s < layers.size(); ++s) sheets[s].share = layers[s].density_per_m2 / total_area;
  return sheets;
}

void slice(std::vector<Sheet>& sheets) {
  struct Piece {
    float height_m;
    double area;
  };
  std::vector<Piece> pieces;
  for (const Sheet& sheet : sheets) {
    for (std::size_t n = 0; n < sheet.elements.size(); ++n) {
      pieces.push_back(
          {sheet.elements.height_m[n], sheet.share * static_cast<double>(sheet.elements.area_m2[n])});
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.height_m > b.height_m; });
  for (Sheet& sheet : sheets) {
    sheet.slice_begin.fill(sheet.elements.size());
    sheet.slice_begin[0] = 0;
  }
  double above = 0.0;
  int next = 1;
  for (const Piece& piece : pieces) {
    const double wanted =
        kTopShare * (std::pow(1.0 + 1.0 / kTopShare, next / static_cast<double>(kSlices)) - 1.0);
    if (above >= wanted && next < kSlices) {
      for (Sheet& sheet : sheets) {
        const auto& heights = sheet.elements.height_m;
        sheet.slice_begin[static_cast<std::size_t>(next)] = static_cast<std::size_t>(
            std::partition_point(heights.begin(), heights.end(),
                                 [&](float height) { return height > piece.height_m; }) -
            heights.begin());
      }
      ++next;
    }
    above += piece.area;
  }
}

// A block of elements as seen along a view: their areas and the normals of their halves.
constexpr std::size_t kBlock = 128;
struct Faces {
  std::array<float, kBlock> area, left_x, left_y, left_z, right_x, right_y, right_z;
};

void face(const SwardElements& elements, std::size_t first, std::size_t count, glm::vec3 to_eye, Faces& out) {
  Kernels kernels;
  const float* ax = elements.along_x.data() + first;
  const float* ay = elements.along_y.data() + first;
  const float* az = elements.along_z.data() + first;
  const float* sx = elements.side_x.data() + first;
  const float* sy = elements.side_y.data() + first;
  const float* sz = elements.side_z.data() + first;
  const float* reach = elements.reach_m.data() + first;
  for (std::size_t n = 0; n < count; ++n) {
    const glm::vec3 along(ax[n], ay[n], az[n]);
    const glm::vec3 side(sx[n], sy[n], sz[n]);
    const auto surface = kernels.blade_surface(along, side, to_eye);
    out.area[n] = reach[n] * glm::abs(kernels.inner(kernels.outer(surface.side, along), to_eye));
    out.left_x[n] = surface.left.x;
    out.left_y[n] = surface.left.y;
    out.left_z[n] = surface.left.z;
    out.right_x[n] = surface.right.x;
    out.right_y[n] = surface.right.y;
    out.right_z[n] = surface.right.z;
  }
}

// Sums over the elements of a slice of a sheet, weighted by the area seen: light from all sides, and from the
// sun at each azimuth.
struct SliceSums {
  Lanes all_round{};
  std::array<Lanes, kAzimuths> sunlit{};
};

void add_sunlit(const Faces& faces, std::span<const Lit> lit, glm::vec3 sun, Lanes& sums) {
  std::array<float, kBlock> front, back;
  for (std::size_t n = 0; n < lit.size(); ++n) {
    const float left = faces.left_x[n] * sun.x + faces.left_y[n] * sun.y + faces.left_z[n] * sun.z;
    const float right = faces.right_x[n] * sun.x + faces.right_y[n] * sun.y + faces.right_z[n] * sun.z;
    front[n] = 0.5f * faces.area[n] * (glm::max(left, 0.0f) + glm::max(right, 0.0f));
    back[n] = 0.5f * faces.area[n] * (glm::max(-left, 0.0f) + glm::max(-right, 0.0f));
  }
  Lanes sum = sums;
  for (std::size_t n = 0; n < lit.size(); ++n) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      sum[lane] += front[n] * lit[n].front[lane] + back[n] * lit[n].back[lane];
  }
  sums = sum;
}

SliceSums sums_of(const Sheet& sheet, std::size_t first, std::size_t last, glm::vec3 to_eye,
                  const std::array<glm::vec3, kAzimuths>& suns) {
  SliceSums sums;
  Faces faces;
  for (std::size_t block = first; block < last; block += kBlock) {
    const std::size_t count = std::min(kBlock, last - block);
    const std::span<const Lit> lit(sheet.lit.data() + block, count);
    face(sheet.elements, block, count, to_eye, faces);
    for (std::size_t n = 0; n < count; ++n) add(sums.all_round, lit[n].all_round, faces.area[n]);
    for (std::size_t a = 0; a < kAzimuths; ++a) add_sunlit(faces, lit, suns[a], sums.sunlit[a]);
  }
  return sums;
}

// One elevation: sums by sheet and slice.
using View = std::vector<std::array<SliceSums, kSlices>>;

double area_seen(const std::array<SliceSums, kSlices>& slices) {
  double sum = 0.0;
  for (const SliceSums& sums : slices) sum += static_cast<double>(sums.all_round[7]);
  return sum;
}

// Share of each slice's leaf area that is seen at an optical depth. Within a slice leaf area lies evenly, so
// that it is e^(−τ above) (1 − e^(−Δτ)) / Δτ.
std::array<double, kSlices> visibility(const std::vector<Sheet>& sheets, const View& view, double projected,
                                       double depth) {
  std::array<double, kSlices> visible;
  double above = 0.0;
  for (std::size_t b = 0; b < kSlices; ++b) {
    double slice = 0.0;
    for (std::size_t s = 0; s < sheets.size(); ++s)
      slice += sheets[s].share * static_cast<double>(view[s][b].all_round[7]);
    slice *= depth / projected;
    visible[b] = std::exp(-above) * (slice > 1e-9 ? -std::expm1(-slice) / slice : 1.0);
    above += slice;
  }
  return visible;
}

struct Seen {
  std::array<double, kLanes> lanes{};
  void add(const Seen& other, double share) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] += share * other.lanes[lane];
  }
  double area() const { return lanes[7]; }
};

// Of one blade of each m², so that a species that is sown nowhere has its colour too.
Seen seen_of(const std::array<SliceSums, kSlices>& slices, std::size_t azimuth,
             const std::array<double, kSlices>& visible) {
  Seen seen;
  for (std::size_t b = 0; b < kSlices; ++b) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      seen.lanes[lane] +=
          visible[b] * static_cast<double>(slices[b].all_round[lane] + slices[b].sunlit[azimuth][lane]);
    }
  }
  return seen;
}

void store(SwardResponse::Colors& colors, std::size_t node, const Seen& seen, glm::dvec3 contour,
           double alpha) {
  if (seen.area() <= 0.0) return;
  const auto& lanes = seen.lanes;
  const glm::dvec3 rim = contour * lanes[6];
  const glm::dvec3 free = (glm::dvec3(lanes[0], lanes[1], lanes[2]) + rim) / seen.area();
  const glm::dvec3 shaded = (glm::dvec3(lanes[3], lanes[4], lanes[5]) + rim) / seen.area();
  colors.free[node] = glm::vec4(glm::dvec4(free, alpha));
  colors.shaded[node] = glm::vec4(glm::dvec4(shaded, alpha));
}

SwardResponse::Colors blank_colors() {
  constexpr std::size_t kNodes = static_cast<std::size_t>(kElevations) * kAzimuths * kDepths;
  return {std::vector<glm::vec4>(kNodes, glm::vec4(0.0f)), std::vector<glm::vec4>(kNodes, glm::vec4(0.0f))};
}

// The sward being alike all round, the view stays and the sun goes round, which turns each blade only once.
std::array<glm::vec3, kAzimuths> suns_around(glm::vec3 sun) {
  std::array<glm::vec3, kAzimuths> suns;
  const double level = std::hypot(static_cast<double>(sun.x), static_cast<double>(sun.y));
  for (std::size_t a = 0; a < kAzimuths; ++a) {
    const double azimuth = std::numbers::pi * static_cast<double>(a) / (kAzimuths - 1);
    suns[a] = glm::vec3(glm::dvec3(level * std::cos(azimuth), level * std::sin(azimuth), sun.z));
  }
  return suns;
}

void fill_elevation(const std::vector<Sheet>& sheets, const LightParams& light, std::size_t elevation,
                    SwardResponse& response) {
  const double sine = sine_at(static_cast<int>(elevation));
  const glm::vec3 to_eye(glm::dvec3(std::sqrt(std::max(1.0 - sine * sine, 0.0)), 0.0, sine));
  const std::array<glm::vec3, kAzimuths> suns = suns_around(light.sun_direction);
  View view(sheets.size());
  double projected = 0.0;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const Sheet& sheet = sheets[s];
    for (std::size_t b = 0; b < kSlices; ++b)
      view[s][b] = sums_of(sheet, sheet.slice_begin[b], sheet.slice_begin[b + 1], to_eye, suns);
    const double seen = area_seen(view[s]);
    response.layers[s].projected[elevation] = static_cast<float>(seen / response.layers[s].blade_area_m2);
    projected += sheet.share * seen;
  }
  response.projected[elevation] = static_cast<float>(projected);

  const glm::dvec3 contour = glm::dvec3(light.horizon_radiance) *
                             static_cast<double>(Kernels{}.power10(1.0f - static_cast<float>(sine)));
  std::vector<Seen> seen(sheets.size());
  for (std::size_t d = 0; d < kDepths; ++d) {
    const std::array<double, kSlices> visible =
        visibility(sheets, view, projected, depth_at(static_cast<int>(d)));
    for (std::size_t a = 0; a < kAzimuths; ++a) {
      const std::size_t node = (d * kAzimuths + a) * kElevations + elevation;
      Seen all;
      for (std::size_t s = 0; s < sheets.size(); ++s) {
        seen[s] = seen_of(view[s], a, visible);
        all.add(seen[s], sheets[s].share);
      }
      store(response.colors, node, all, contour, projected);
      for (std::size_t s = 0; s < sheets.size(); ++s)
        store(response.layers[s].colors, node, seen[s], contour,
              sheets[s].share * seen[s].area() / all.area());
    }
  }
}

}  // namespace

SwardResponse sward_response(std::span<const SwardLayer> layers, const LightParams& light) {
  std::vector<Sheet> sheets = sheets_of(layers, light);
  slice(sheets);
  SwardResponse response;
  response.projected.resize(kElevations);
  response.colors = blank_colors();
  for (const Sheet& sheet : sheets) {
    SwardResponse::Layer layer;
    for (const float area_m2 : sheet.elements.area_m2) layer.blade_area_m2 += static_cast<double>(area_m2);
    layer.projected.resize(kElevations);
    layer.colors = blank_colors();
    response.layers.push_back(std::move(layer));
  }
  oneapi::tbb::parallel_for(
      std::size_t{0}, static_cast<std::size_t>(kElevations),
      [&](std::size_t elevation) { fill_elevation(sheets, light, elevation, response); });
  return response;
}

glm::vec3 sward_place(double sin_elevation, double azimuth_to_sun_rad, double optical_depth) {
  const double lowest = std::sqrt(kLowestSine);
  const double x = (std::sqrt(std::max(sin_elevation, 0.0)) - lowest) / (1.0 - lowest);
  const double y = std::abs(azimuth_to_sun_rad) / std::numbers::pi;
  const double z = std::log1p(optical_depth) / std::log1p(kDeepest);
  return glm::vec3(glm::clamp(glm::dvec3(x, y, z), 0.0, 1.0));
}

}  // namespace prairie
