// `prairie plant`: the blades of chosen tiles as a table, or the hashes by which plantings are compared.
// Tiles stream through: memory does not grow with their number.
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/commands/scene_options.h"
#include "app/outputs/blade_table.h"
#include "app/outputs/outputs.h"
#include "app/outputs/streamed_output.h"
#include "app/scenes/chosen_tiles.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/progress.h"
#include "app/terminal/usage_error.h"
#include "generator/blade_census.h"
#include "generator/plant.h"
#include "world/world.h"

namespace prairie {
namespace {

struct PlantOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::optional<TileRange> tiles;
  bool hashes = false;
};

/// Tiles in the order of every output: by j, then i.
TileId tile_at(const TileRange& tiles, std::int64_t position) {
  const std::int64_t columns = tiles.last.i - tiles.first.i + 1;
  return {tiles.first.i + static_cast<int>(position % columns),
          tiles.first.j + static_cast<int>(position / columns)};
}

std::uint64_t total_count(const Meadow& meadow, const TileRange& tiles) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::int64_t>(0, tiles.count()), std::uint64_t{0},
      [&](const tbb::blocked_range<std::int64_t>& part, std::uint64_t sum) {
        for (std::int64_t k = part.begin(); k < part.end(); ++k)
          sum += planted_count(meadow, tile_at(tiles, k));
        return sum;
      },
      std::plus<>());
}

/// Before hours of writing: how much it will be.
void say_how_much(const Meadow& meadow, const PlantOptions& options, const GlobalOptions& globals) {
  if (options.tiles || globals.quiet) return;
  double blades = 0.0;
  for (const double of_species : blade_census(meadow).blades) blades += of_species;
  constexpr double kMuch = 1e8;
  constexpr double kGigabytesPerBlade = 1.2e-7;  // as text
  if (blades < kMuch) return;
  say_warning(fmt::format(
      "all tiles have some {:.2g} blades, about {:.2g} GB; --tiles chooses some, --hashes is short", blades,
      kGigabytesPerBlade * blades));
}

BladeTableFormat table_format(const std::filesystem::path& path) {
  const std::string suffix = path.extension().string();
  if (suffix == ".csv" || path == kStandardOutput) return BladeTableFormat::kCsv;
  if (suffix == ".ply") return BladeTableFormat::kPly;
  throw UsageError("--output", path.string(),
                   "a file name that ends in .csv or .ply, or - for CSV on stdout");
}

/// Plants tiles in parallel, a few per thread at a time, and writes them in order.
std::uint64_t write_blades(const Meadow& meadow, const TileRange& tiles, BladeTableFormat format,
                           StreamedOutput& output, Progress& progress) {
  std::int64_t next = 0;
  std::uint64_t written = 0;
  struct Rows {
    std::string text;
    std::uint64_t blades = 0;
  };
  const auto take_tile = [&](tbb::flow_control& flow) -> std::int64_t {
    if (next == tiles.count()) {
      flow.stop();
      return 0;
    }
    return next++;
  };
  const auto plant = [&](std::int64_t position) {
    const TileId tile = tile_at(tiles, position);
    const std::vector<Blade> blades = plant_tile(meadow, tile);
    return std::make_shared<const Rows>(Rows{blade_rows(format, meadow, tile, blades), blades.size()});
  };
  const auto write = [&](const std::shared_ptr<const Rows>& rows) {
    output.write(rows->text);
    written += rows->blades;
    progress.advance();
  };
  constexpr std::size_t kTilesPerThread = 3;
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  tbb::parallel_pipeline(
      kTilesPerThread * threads,
      tbb::make_filter<void, std::int64_t>(tbb::filter_mode::serial_in_order, take_tile) &
          tbb::make_filter<std::int64_t, std::shared_ptr<const Rows>>(tbb::filter_mode::parallel, plant) &
          tbb::make_filter<std::shared_ptr<const Rows>, void>(tbb::filter_mode::serial_in_order, write));
  return written;
}

void write_hashes(const Meadow& meadow, const TileRange& tiles, StreamedOutput& output, Progress& progress) {
  for (int j = tiles.first.j; j <= tiles.last.j; ++j) {
    const std::vector<std::uint64_t> hashes = tile_hashes(meadow, {{tiles.first.i, j}, {tiles.last.i, j}});
    std::string lines;
    for (std::size_t k = 0; k < hashes.size(); ++k) {
      lines += fmt::format("{} {} {:016x}\n", tiles.first.i + static_cast<int>(k), j, hashes[k]);
      progress.advance();
    }
    output.write(lines);
  }
}

int plant_tiles(const PlantOptions& options, const GlobalOptions& globals) {
  const BladeTableFormat format = options.hashes ? BladeTableFormat::kCsv : table_format(options.output);
  if (options.output != kStandardOutput) check_output_file(options.output);
  const World world = open_world(options.folder, globals);
  const Meadow& meadow = world.meadow();
  const TileRange tiles = chosen_tiles(options.tiles, meadow);
  if (!options.hashes) say_how_much(meadow, options, globals);
  StreamedOutput output(options.output);
  std::uint64_t blades = 0;
  {
    Progress progress("tile", static_cast<std::uint64_t>(tiles.count()), globals.quiet);
    if (options.hashes) {
      write_hashes(meadow, tiles, output, progress);
    } else {
      // Only a PLY tells it at its head.
      const std::uint64_t total = format == BladeTableFormat::kPly ? total_count(meadow, tiles) : 0;
      output.write(blade_table_header(format, meadow, total));
      blades = write_blades(meadow, tiles, format, output, progress);
    }
  }
  output.finish();
  const std::string what = options.hashes ? fmt::format("hashes of {} tiles", tiles.count())
                                          : fmt::format("{} blades of {} tiles", blades, tiles.count());
  say_done(fmt::format("{}: {}", options.output.string(), what), globals.quiet);
  return kExitFine;
}

}  // namespace

Command plant_command() {
  const auto options = std::make_shared<PlantOptions>();
  Command command{"plant", "Writes the blades of tiles as CSV or PLY, or the tiles' hashes"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "-o,--output",
       .type = "FILE",
       .help = "A .csv or binary .ply file; - is stdout, as CSV",
       .target = text_into(options->output),
       .is_required = true},
      chosen_tiles_option(options->tiles),
      {.names = "--hashes", .help = "Text lines 'i j HASH' instead of blades", .target = &options->hashes},
  };
  command.footer =
      "Examples:\n"
      "  prairie plant examples/meadow -o blades.csv --tiles 4,4,5,5\n"
      "  prairie plant examples/meadow -o meadow.ply\n"
      "  prairie plant examples/meadow -o - --hashes | sha256sum";
  command.run = [options](const GlobalOptions& globals) { return plant_tiles(*options, globals); };
  return command;
}

}  // namespace prairie
