// Ranges that the rooms below check themselves, so that no limit is written down twice: the reader takes any
// number, and what such a check refuses becomes a fault of the scene file's key, with its line.
#pragma once

#include <functional>
#include <string>

#include "world/scene/toml_reader.h"

namespace prairie {

/// Runs `check`. Its BadInput, which names a field of the table after `prefix`, is thrown as the table's own.
void check_by(const TableReader& table, const std::string& prefix, const std::function<void()>& check);

}  // namespace prairie
