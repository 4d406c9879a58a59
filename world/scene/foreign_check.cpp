#include "world/scene/foreign_check.h"

#include "files/error.h"

namespace prairie {

void check_by(const TableReader& table, const std::string& prefix, const std::function<void()>& check) {
  try {
    check();
  } catch (const BadInput& fault) {
    const bool has_prefix = fault.field.starts_with(prefix);
    table.refuse(has_prefix ? fault.field.substr(prefix.size()) : fault.field, fault.found, fault.expected);
  }
}

}  // namespace prairie
