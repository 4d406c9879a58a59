#include "app/commands/picture_options.h"

#include <fmt/format.h>

#include "app/terminal/option_values.h"

namespace prairie {

void add_size_option(CLI::App& command, glm::ivec2& size_px) {
  command
      .add_option_function<std::string>(
          "--size", [&size_px](const std::string& text) { size_px = size_option("--size", text); },
          fmt::format("Pixels ({}x{})", size_px.x, size_px.y))
      ->type_name("WxH");
}

void add_samples_option(CLI::App& command, int& samples) {
  command
      .add_option_function<std::string>(
          "--samples",
          [&samples](const std::string& text) { samples = int_option("--samples", text, 1, kMaxSamples); },
          "Frames averaged per picture, for smooth edges (1)")
      ->type_name("N");
}

void add_tier_option(CLI::App& command, Tier& tier) {
  command
      .add_option_function<std::string>(
          "--tier", [&tier](const std::string& text) { tier = tier_option("--tier", text); },
          "How grass is drawn: auto, spline, hermite, strip or flat (auto)")
      ->type_name("TIER");
}

}  // namespace prairie
