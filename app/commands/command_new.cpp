// `prairie new`: the command line of app/scenes/new_scene.h.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/crowd_spec.h"
#include "app/commands/commands.h"
#include "app/scenes/new_scene.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

constexpr double kLargest = 1e9;

std::array<double, 2> range_option(const std::string& option, const std::string& text) {
  const std::vector<std::string> ends = split(text, ',');
  if (ends.size() != 2) throw UsageError(option, text, "two numbers LO,HI");
  const std::array range{number_option(option, ends[0], -kLargest, kLargest),
                         number_option(option, ends[1], -kLargest, kLargest)};
  if (range[0] == range[1]) throw UsageError(option, text, "two different numbers LO,HI");
  return range;
}

std::array<int, 2> raw_size_option(const std::string& option, const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  if (sides.size() != 2) throw UsageError(option, text, "columns and rows WxH");
  constexpr int kMostSide = 100'000;
  return {int_option(option, sides[0], 1, kMostSide), int_option(option, sides[1], 1, kMostSide)};
}

struct NewOptions {
  NewSceneRequest request;
  std::vector<std::string> height_files;
  std::optional<std::filesystem::path> density_file;
  DensityRequest density;  // of that file, if there is one
};

int make_scene(const NewOptions& options, const GlobalOptions& globals) {
  NewSceneRequest request = options.request;
  if (options.density_file) {
    request.density = options.density;
    request.density->file = *options.density_file;
  }
  request.height_files.assign(options.height_files.begin(), options.height_files.end());
  request.seed = globals.seed.value_or(request.seed);
  request.memory_budget_bytes = globals.max_memory_bytes;
  request.decoder = globals.decoder;
  for (const std::string& warning : new_scene(request)) {
    if (!globals.quiet) say_warning(warning);
  }
  say_done("made " + request.folder.string(), globals.quiet);
  return kExitFine;
}

std::vector<CommandOption> density_options(NewOptions& options) {
  return {
      {.names = "--density",
       .type = "FILE",
       .help = "Your own density raster",
       .target = text_into(options.density_file)},
      {.names = "--density-channel",
       .type = "NAME",
       .help = "Which of its channels: R, G, B, A, another name, or a number from 1",
       .target = text_into(options.density.channel),
       .needs = "--density"},
      {.names = "--density-spacing",
       .type = "METRES",
       .help = "Metres between its pixels, where it does not say (fitted to the ground)",
       .target = number_into(options.density.spacing_m, 1e-3, 1e4),
       .needs = "--density"},
      {.names = "--density-nodata",
       .type = "V",
       .help = "The value that means no data, where it does not say",
       .target = number_into(options.density.nodata, -1e300, 1e300),
       .needs = "--density"},
      {.names = "--density-range",
       .type = "LO,HI",
       .help = "Raster values of density 0 and of the largest density (0,1 or the type's full range)",
       .target = parsed_into(options.density.range, range_option),
       .needs = "--density"},
      {.names = "--density-curve",
       .type = "G",
       .help = "Exponent G of density = N · clamp((v − LO)/(HI − LO), 0, 1)^G (1)",
       .target = number_into(options.density.curve, 0.01, 100.0),
       .needs = "--density"},
      {.names = "--density-max",
       .type = "N",
       .help = "Blades per m² at the top of the range (1000)",
       .target = number_into(options.density.max_per_m2, 0.0, 1e5),
       .needs = "--density"},
  };
}

std::vector<CommandOption> height_options(NewOptions& options) {
  NewSceneRequest& request = options.request;
  return {
      {.names = "--height",
       .type = "FILE",
       .help = "Your own height raster instead of made-up ground; several, or a folder, for a mosaic",
       .target = &options.height_files},
      {.names = "--height-range",
       .type = "LO,HI",
       .help = "Heights in metres of an integer raster's 0 and largest value, of a float raster's 0 and 1",
       .target = parsed_into(request.height_range_m, range_option),
       .needs = "--height"},
      {.names = "--height-scale",
       .type = "METRES",
       .help = "Metres per unit of the raster's values (what it says, else 1)",
       .target = number_into(request.height_scale, 1e-6, 1e6),
       .needs = "--height"},
      {.names = "--height-nodata",
       .type = "V",
       .help = "The value that means no data, where it does not say",
       .target = number_into(request.height_nodata, -1e300, 1e300),
       .needs = "--height"},
      {.names = "--height-size",
       .type = "WxH",
       .help = "Columns and rows of a raw file (.r16, .raw) of 16-bit integers",
       .target = parsed_into(request.height_size_px, raw_size_option),
       .needs = "--height"},
      {.names = "--height-crs",
       .type = "EPSG:N",
       .help = "The raster's coordinate system, where it does not say",
       .target = text_into(request.height_crs),
       .needs = "--height"},
  };
}

}  // namespace

Command new_command() {
  const auto options = std::make_shared<NewOptions>();
  NewSceneRequest& request = options->request;
  Command command{"new", "Makes a scene folder to start from"};
  command.options = {
      {.names = "DIR",
       .help = "The folder to make",
       .target = text_into(request.folder),
       .is_required = true},
      {.names = "--force", .help = "Write into a folder that is not empty", .target = &request.force},
      {.names = "--spacing",
       .type = "METRES",
       .help = "Metres between the pixels of the height raster (without one, the density raster's), where it "
               "does not say",
       .target = number_into(request.height_spacing_m, 1e-3, 1e4)},
      {.names = "--walkers",
       .type = "N",
       .help = "So many people who wander there (0)",
       .target = whole_number_into(request.walkers, 0, static_cast<int>(kMostWalkers))},
  };
  for (CommandOption& option : height_options(*options)) command.options.push_back(std::move(option));
  for (CommandOption& option : density_options(*options)) command.options.push_back(std::move(option));
  command.footer =
      "Examples:\n"
      "  prairie new meadow\n"
      "  prairie new park --walkers 50\n"
      "  prairie new hills --height dtm.tif\n"
      "  prairie new konza --height dtm.tif --density ndvi.tif --density-range 0.2,0.9 --density-curve 1.5";
  command.run = [options](const GlobalOptions& globals) { return make_scene(*options, globals); };
  return command;
}

}  // namespace prairie
