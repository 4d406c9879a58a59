// `prairie new`: the command line of app/scenes/new_scene.h.
#include <array>
#include <memory>

#include "agents/crowd_spec.h"
#include "app/commands/commands.h"
#include "app/scenes/new_scene.h"
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

struct NewOptions {
  NewSceneRequest request;
  DensityRequest density;
};

}  // namespace

void add_new_command(CLI::App& app, const GlobalOptions& globals, Command& chosen) {
  CLI::App* command = app.add_subcommand("new", "Makes a scene folder to start from");
  auto options = std::make_shared<NewOptions>();
  NewSceneRequest& request = options->request;
  DensityRequest& density = options->density;
  command->add_option("DIR", request.folder, "The folder to make")->required()->type_name("");
  command->add_flag("--force", request.force, "Write into a folder that is not empty");
  CLI::Option* height =
      command->add_option("--height", request.height_file, "Your own height raster instead of made-up ground")
          ->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "--height-range",
          [&request](const std::string& text) {
            request.height_range_m = range_option("--height-range", text);
          },
          "Heights in metres of an integer raster's 0 and largest value")
      ->type_name("LO,HI")
      ->needs(height);
  command
      ->add_option_function<std::string>(
          "--spacing",
          [&request](const std::string& text) {
            request.height_spacing_m = number_option("--spacing", text, 1e-3, 1e4);
          },
          "Metres between the pixels of the height raster (without one, the density raster's), where it does "
          "not say")
      ->type_name("METRES");
  command
      ->add_option_function<std::string>(
          "--walkers",
          [&request](const std::string& text) {
            request.walkers =
                static_cast<std::uint32_t>(int_option("--walkers", text, 0, static_cast<int>(kMostWalkers)));
          },
          "So many people who wander there (0)")
      ->type_name("N");
  CLI::Option* density_file =
      command->add_option("--density", density.file, "Your own density raster")->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "--density-range",
          [&density](const std::string& text) { density.range = range_option("--density-range", text); },
          "Raster values of density 0 and of the largest density (0,1 or the type's full range)")
      ->type_name("LO,HI")
      ->needs(density_file);
  command
      ->add_option_function<std::string>(
          "--density-curve",
          [&density](const std::string& text) {
            density.curve = number_option("--density-curve", text, 0.01, 100.0);
          },
          "Exponent G of density = N · clamp((v − LO)/(HI − LO), 0, 1)^G (1)")
      ->type_name("G")
      ->needs(density_file);
  command
      ->add_option_function<std::string>(
          "--density-max",
          [&density](const std::string& text) {
            density.max_per_m2 = number_option("--density-max", text, 0.0, 1e5);
          },
          "Blades per m² at the top of the range (1000)")
      ->type_name("N")
      ->needs(density_file);
  command->footer(
      "Examples:\n"
      "  prairie new meadow\n"
      "  prairie new park --walkers 50\n"
      "  prairie new hills --height dtm.tif\n"
      "  prairie new konza --height dtm.tif --density ndvi.tif --density-range 0.2,0.9 --density-curve 1.5");
  command->callback([options, density_file, &globals, &chosen] {
    chosen = [options, density_file, &globals] {
      if (density_file->count() > 0) options->request.density = options->density;
      options->request.seed = globals.seed.value_or(options->request.seed);
      options->request.memory_budget_bytes = globals.max_memory_bytes;
      new_scene(options->request);
      say_done("made " + options->request.folder.string(), globals.quiet);
      return 0;
    };
  });
}

}  // namespace prairie
