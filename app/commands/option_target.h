// Where the values of command-line options go, and how they are read on their way there. What is given by
// reference or pointer must live as long as the target.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/terminal/option_values.h"

namespace prairie {

/// Takes the text of an option's value. Throws UsageError, which names the option.
using TextTarget = std::function<void(const std::string& option, const std::string& text)>;

/// Of a flag, which is set; of an option that may be repeated, all of whose texts are kept; of any other.
using OptionTarget = std::variant<bool*, std::vector<std::string>*, TextTarget>;

/// Keeps what `parse` (one of app/terminal/option_values.h, for example) makes of option and text.
template <typename Value, typename Parse>
TextTarget parsed_into(Value& value, Parse parse) {
  return [&value, parse](const std::string& option, const std::string& text) { value = parse(option, text); };
}

/// Keeps the text as it is, in a string, a path or an optional one.
template <typename Value>
TextTarget text_into(Value& value) {
  return parsed_into(value, [](const std::string&, const std::string& text) { return text; });
}

template <typename Value>
TextTarget whole_number_into(Value& value, int least, int most) {
  return parsed_into(value, [least, most](const std::string& option, const std::string& text) {
    return int_option(option, text, least, most);
  });
}

template <typename Value>
TextTarget number_into(Value& value, double least, double most) {
  return parsed_into(value, [least, most](const std::string& option, const std::string& text) {
    return number_option(option, text, least, most);
  });
}

}  // namespace prairie
