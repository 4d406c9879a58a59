#include "app/scenes/chosen_tiles.h"

#include <fmt/format.h>

#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

std::string corners(const TileRange& tiles) {
  return fmt::format("{},{},{},{}", tiles.first.i, tiles.first.j, tiles.last.i, tiles.last.j);
}

}  // namespace

TileRange chosen_tiles(const std::optional<TileRange>& asked, const Meadow& meadow) {
  const TileRange all = tiles_of(meadow);
  if (!asked) return all;
  if (!meadow.repeats && !(all.contains(asked->first) && all.contains(asked->last))) {
    throw UsageError("--tiles", corners(*asked), "tiles within " + corners(all));
  }
  return *asked;
}

}  // namespace prairie
