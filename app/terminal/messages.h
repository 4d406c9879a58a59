// What the program says to a person: one line each on stderr, never on stdout, which carries data alone.
#pragma once

#include <string>

namespace prairie {

/// "prairie: …", in red on a terminal unless NO_COLOR is set. Line breaks inside become spaces.
void say_fault(const std::string& text);
void say_warning(const std::string& text);

/// What a finished command has done; nothing where `quiet`.
void say_done(const std::string& text, bool quiet);

}  // namespace prairie
