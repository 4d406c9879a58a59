#include "app/commands/picture_options.h"

#include <fmt/format.h>

namespace prairie {

CommandOption picture_size_option(glm::ivec2& size_px) {
  return {.names = "--size",
          .type = "WxH",
          .help = fmt::format("Pixels ({}x{})", size_px.x, size_px.y),
          .target = parsed_into(size_px, size_option)};
}

CommandOption picture_samples_option(int& samples) {
  return {.names = "--samples",
          .type = "N",
          .help = "Frames averaged per picture, for smooth edges (1)",
          .target = whole_number_into(samples, 1, kMaxSamples)};
}

CommandOption parallel_option(std::optional<double>& height_m) {
  constexpr double kLeastM = 0.01, kMostM = 1e5;
  return {.names = "--parallel",
          .type = "METRES",
          .help = "Draw in parallel projection: so many metres from the lower to the upper edge",
          .target = number_into(height_m, kLeastM, kMostM)};
}

CommandOption picture_tier_option(Tier& tier) {
  return {.names = "--tier",
          .type = "TIER",
          .help = "How grass is drawn: auto, spline, hermite, strip or flat (auto)",
          .target = parsed_into(tier, tier_option)};
}

CommandOption lod_eye_option(std::optional<glm::dvec3>& lod_eye_m, const std::string& default_eye) {
  return {.names = "--lod-eye",
          .type = "X,Y,Z",
          .help = fmt::format("Tiers are chosen for an eye there, in metres ({})", default_eye),
          .target = parsed_into(lod_eye_m, place_option)};
}

}  // namespace prairie
