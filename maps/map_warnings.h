// What a map's values give reason to refuse, or to warn of.
#pragma once

#include <string>
#include <vector>

#include "files/warning.h"
#include "maps/map_file.h"
#include "maps/value_mapping.h"

namespace prairie {

/// Throws BadInput where no node has data, or heights are none.
void check_census(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census);

/// `spacing_m`: between the nodes.
std::vector<Warning> map_warnings(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census,
                                  double spacing_m);

/// About a map, named as its warnings are.
Warning map_note(const MapSpec& spec, const char* code, const std::string& text);

}  // namespace prairie
