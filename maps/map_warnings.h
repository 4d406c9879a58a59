// What a map's values look like once all were seen: refusals, and what its maker probably did not mean.
#pragma once

#include <string>
#include <vector>

#include "maps/map_file.h"
#include "maps/value_mapping.h"

namespace prairie {

/// Throws BadInput where no pixel has data, or heights are none of any planet.
void check_census(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census);

/// One line each. `notes`: what else is to be told; empty ones are left out.
std::vector<std::string> map_warnings(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census,
                                      const std::vector<std::string>& notes);

}  // namespace prairie
