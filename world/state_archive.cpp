#include "world/state_archive.h"

#include "files/error.h"

namespace prairie {

void StateReader::end() const {
  if (!rest_.empty()) refuse(fmt::format("{} more bytes", rest_.size()), "the end of the file");
}

void StateReader::refuse(const std::string& found, const std::string& expected) const {
  throw BadInput(file_, section_, found, expected);
}

}  // namespace prairie
