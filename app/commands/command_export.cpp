// `prairie export`: pictures of single tiles from standard views, and a manifest that says what they are.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/replay_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/state_options.h"
#include "app/outputs/export_manifest.h"
#include "app/outputs/outputs.h"
#include "app/outputs/picture_file.h"
#include "app/scenes/chosen_tiles.h"
#include "app/scenes/installed_files.h"
#include "app/scenes/open_world.h"
#include "app/scenes/tile_views.h"
#include "app/scenes/world_time.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "app/terminal/progress.h"
#include "files/sha256.h"
#include "generator/plant.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"
#include "world/world.h"

namespace prairie {
namespace {

struct ExportOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::optional<TileRange> tiles;
  std::vector<TileView> views{kTileViews.begin(), kTileViews.end()};
  std::vector<Tier> tiers{Tier::kAuto};
  std::optional<glm::dvec3> lod_eye_m;
  glm::ivec2 size_px{512, 512};
  int samples = 1;
  ReplayOptions replay;
  StateOptions state;
};

struct Shot {
  TileId tile;
  TileView view;
  Tier tier;
};

// Each view and tier once and in a fixed order, so that the files come in the same order however they are
// asked for.
template <typename Value>
void sort_and_thin(std::vector<Value>& values) {
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
}

std::vector<TileView> views_option(const std::string& option, const std::string& text) {
  std::vector<std::string> names;
  for (const TileView view : kTileViews) names.emplace_back(tile_view_name(view));
  std::vector<TileView> views;
  for (const std::string& name : split(text, ',')) {
    choice_option(option, name, names);
    views.push_back(*std::ranges::find(kTileViews, name, tile_view_name));
  }
  sort_and_thin(views);
  return views;
}

std::vector<Tier> tiers_option(const std::string& option, const std::string& text) {
  std::vector<Tier> tiers;
  for (const std::string& name : split(text, ',')) tiers.push_back(tier_option(option, name));
  sort_and_thin(tiers);
  return tiers;
}

std::vector<Shot> all_shots(const TileRange& tiles, const ExportOptions& options) {
  std::vector<Shot> shots;
  for (int j = tiles.first.j; j <= tiles.last.j; ++j) {
    for (int i = tiles.first.i; i <= tiles.last.i; ++i) {
      for (const TileView view : options.views) {
        for (const Tier tier : options.tiers) shots.push_back({{i, j}, view, tier});
      }
    }
  }
  return shots;
}

ExportedFile export_shot(const Shot& shot, const Camera& camera, const ExportOptions& options,
                         const GlobalOptions& globals, const World& world, Renderer& renderer) {
  FrameOptions frame;
  frame.tier = shot.tier;
  frame.lod_eye_m = options.lod_eye_m;
  frame.memory_budget_bytes = globals.max_memory_bytes;
  const Picture picture = renderer.render(camera, frame, options.samples);
  const std::vector<std::byte> bytes = encoded_picture(picture, PictureFormat::kPng);

  ExportedFile file;
  file.tile = shot.tile;
  file.view = tile_view_name(shot.view);
  file.tier = tier_name(shot.tier);
  file.name = fmt::format("tile_{}_{}_{}_{}.png", shot.tile.i, shot.tile.j, file.view, file.tier);
  file.blades_planted = planted_count(world.meadow(), shot.tile);
  file.blades_drawn = renderer.picture_statistics().blades_drawn;
  file.sha256 = sha256_hex(bytes);
  write_output(options.output / file.name, bytes);
  return file;
}

int export_tiles(const ExportOptions& options, const GlobalOptions& globals) {
  check_picture_budget(options.size_px, globals.max_memory_bytes);
  World world = open_world(options.folder, globals);
  const std::vector<Shot> shots = all_shots(chosen_tiles(options.tiles, world.meadow()), options);

  const double tallest_m = tallest_blade_m(world.meadow());  // once: it reads a whole map
  replay_as_asked(options.replay, globals, world);
  begin_as_asked(options.state, world);
  save_asked_state(options.state, world);

  const HeadlessContext context(globals.device);
  Renderer renderer(world, shader_folder());
  make_output_folder(options.output);
  ExportManifest manifest;
  manifest.scene_hash = world.scene_hash();
  manifest.seed = world.meadow().seed;
  manifest.time_s = world.time_s();
  manifest.program_version = PRAIRIE_VERSION;
  manifest.renderer = renderer_name();
  manifest.width_px = options.size_px.x;
  manifest.height_px = options.size_px.y;
  {
    Progress progress("picture", shots.size(), globals.quiet);
    std::optional<glm::dvec2> watched_m;
    for (const Shot& shot : shots) {
      const Camera camera = tile_camera(world.meadow(), tallest_m, shot.tile, shot.view, options.size_px);
      // Anew, so that no picture depends on which others are made.
      const glm::dvec2 place_m = watched_place_m(camera, world.meadow().ground);
      if (watched_m != place_m) world.watch_anew(place_m);
      watched_m = place_m;
      manifest.files.push_back(export_shot(shot, camera, options, globals, world, renderer));
      progress.advance();
    }
  }
  write_output(options.output / "manifest.json", manifest_json(manifest));
  say_done(fmt::format("{}: {} pictures and manifest.json", options.output.string(), shots.size()),
           globals.quiet);
  return kExitFine;
}

}  // namespace

Command export_command() {
  const auto options = std::make_shared<ExportOptions>();
  Command command{"export", "Makes pictures of single tiles, and a manifest of them"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "-o,--output",
       .type = "OUT",
       .help = "The folder for the pictures; made where it is missing",
       .target = text_into(options->output),
       .is_required = true},
      chosen_tiles_option(options->tiles),
      {.names = "--views",
       .type = "VIEW,…",
       .help = "Some of top, oblique, eye (all)",
       .target = parsed_into(options->views, views_option)},
      lod_eye_option(options->lod_eye_m, "each camera's"),
      {.names = "--tiers",
       .type = "TIER,…",
       .help = "Some of auto, spline, hermite, strip, flat (auto)",
       .target = parsed_into(options->tiers, tiers_option)},
      picture_size_option(options->size_px),
      picture_samples_option(options->samples),
      replay_option(options->replay),
      replay_at_option(options->replay),
      replay_fps_option(options->replay),
      time_option(options->state),
      load_state_option(options->state),
      save_state_option(options->state),
  };
  command.footer =
      "Examples:\n"
      "  prairie export examples/meadow -o tiles\n"
      "  prairie export examples/meadow -o tiles --tiles 4,4,7,7 --views top,oblique --tiers hermite,flat\n"
      "  prairie export examples/meadow -o tiles --tiles 8,8,8,8 --size 1024x768 --samples 8";
  command.run = [options](const GlobalOptions& globals) { return export_tiles(*options, globals); };
  return command;
}

}  // namespace prairie
