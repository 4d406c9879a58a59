// What visits a state's layout (world/state_layout.h): one archive takes the numbers of a state, another sets
// them from bytes. Both have the same operations, so that the layout is told once for all that is done by it.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "files/little_endian.h"

namespace prairie {

/// Hands each number, as wide as it lies in a file, to `Put`.
template <class Put>
class StateWriter {
 public:
  static constexpr bool kReads = false;

  explicit StateWriter(Put put) : put_(std::move(put)) {}

  void enter(const char*) {}
  template <FixedWidth Number>
  void number(const Number& number) {
    put_(number);
  }
  bool flag(bool is_set) {
    put_(std::uint32_t{is_set});
    return is_set;
  }
  template <FixedWidth Width>
  std::size_t count(std::size_t count, std::size_t) {
    put_(static_cast<Width>(count));
    return count;
  }
  template <FixedWidth Number>
  void expect(const char*, const Number& value) {
    put_(value);
  }

 private:
  Put put_;
};

/// Believes nothing: each operation throws BadInput, which names the file and the section, where the bytes do
/// not hold what it takes.
class StateReader {
 public:
  static constexpr bool kReads = true;

  /// The file's name has to outlive this.
  StateReader(std::span<const std::byte> bytes, const std::string& file) : rest_(bytes), file_(file) {}

  /// Begins a section.
  void enter(const char* section) { section_ = section; }

  /// Floating-point numbers have to be finite.
  template <FixedWidth Number>
  void number(Number& number) {
    if (rest_.size() < sizeof(Number)) refuse(fmt::format("{} bytes left", rest_.size()), "a number");
    number = little_endian<Number>(rest_.first(sizeof(Number)));
    rest_ = rest_.subspan(sizeof(Number));
    if constexpr (std::floating_point<Number>) {
      if (!std::isfinite(number)) refuse(fmt::format("{}", number), "finite numbers");
    }
  }

  /// What the file says; the argument is what there is to write.
  bool flag(bool) {
    std::uint32_t flag = 0;
    number(flag);
    if (flag > 1) refuse(fmt::format("{}", flag), "0 or 1");
    return flag == 1;
  }

  /// Of things that take at least `bytes_each`. What the file says; the first argument is what there is to
  /// write.
  template <FixedWidth Width>
  std::size_t count(std::size_t, std::size_t bytes_each) {
    Width count = 0;
    number(count);
    if (count > rest_.size() / bytes_each)
      refuse(fmt::format("a count of {} with {} bytes left", count, rest_.size()),
             fmt::format("at most {}", rest_.size() / bytes_each));
    return static_cast<std::size_t>(count);
  }

  /// A number that has to be the scene's.
  template <FixedWidth Number>
  void expect(const char* name, const Number& value) {
    Number found{};
    number(found);
    if (found != value) refuse(fmt::format("{} {}", name, found), fmt::format("{}, the scene's", value));
  }

  /// Comes after the last number.
  void end() const;

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;

 private:
  std::span<const std::byte> rest_;
  const std::string& file_;
  const char* section_ = "";
};

}  // namespace prairie
