#include "files/joined.h"

namespace prairie {

std::string joined(std::span<const std::string> texts, std::string_view between) {
  std::string row;
  for (const std::string& text : texts) {
    if (&text != texts.data()) row += between;
    row += text;
  }
  return row;
}

}  // namespace prairie
