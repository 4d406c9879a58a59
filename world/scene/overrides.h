// "key=value" on top of a scene file: the value goes into the file's table, where the strict reader then
// judges it.
#pragma once

#include <string>
#include <string_view>

#include "world/scene/toml_reader.h"

namespace prairie {

/// The key of "key=value", for messages; the whole text where there is no '='.
std::string override_key(std::string_view assignment);

/// Sets one dotted key. In an array of tables a segment is an index from 0 or an element's name. The value is
/// TOML, or, where it does not parse as such, text. Throws BadOverride where the key leads nowhere.
void apply_override(toml::table& table, std::string_view assignment);

}  // namespace prairie
