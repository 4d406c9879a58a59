// An error of the command line: the program ends with exit code 2 and a line that names the option.
#pragma once

#include "files/error.h"

namespace prairie {

struct UsageError : Fault {
  UsageError(std::string option, std::string found_text, std::string expected_text)
      : Fault("", std::move(option), std::move(found_text), std::move(expected_text)) {}
};

}  // namespace prairie
