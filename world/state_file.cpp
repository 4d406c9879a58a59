#include "world/state_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "files/error.h"
#include "files/little_endian.h"
#include "world/motion.h"
#include "world/state_archive.h"
#include "world/state_layout.h"

namespace prairie {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'P', 'R', 'S', '\r', '\n', 0x1a, '\n'};
constexpr std::uint32_t kVersion = 2;
constexpr std::uint64_t kUnsealed = 0;  // length and checksum, before all is written
constexpr std::size_t kVersionAt = 8, kLengthAt = 12, kChecksumAt = 20, kHashAt = 28;
static_assert(kHashAt + 8 == kStateHeaderBytes);

std::uint64_t checksum(std::span<const std::byte> bytes) {
  const std::span<const std::byte> rest = bytes.subspan(kHashAt);
  return XXH3_64bits(rest.data(), rest.size());
}

/// What is left of a file behind a header that is in order.
std::span<const std::byte> checked_body(std::span<const std::byte> bytes, const StateOwner& owner,
                                        const std::string& file) {
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throw BadInput(file, "", found, expected);
  };
  const std::size_t lead = std::min(bytes.size(), kMagic.size());
  const bool is_state =
      lead > 0 && std::equal(kMagic.begin(), kMagic.begin() + static_cast<std::ptrdiff_t>(lead),
                             bytes.begin(), [](auto a, auto b) { return std::byte{a} == b; });
  if (!is_state) refuse("no state", "a file that --save-state wrote");
  if (bytes.size() < kStateHeaderBytes)
    refuse(fmt::format("a state cut short, {} bytes", bytes.size()), "the whole file");
  const auto version = little_endian<std::uint32_t>(bytes.subspan(kVersionAt, 4));
  if (version != kVersion)
    refuse(fmt::format("a state of version {}{}", version, version > kVersion ? ", of a newer program" : ""),
           fmt::format("version {}", kVersion));
  const auto length = little_endian<std::uint64_t>(bytes.subspan(kLengthAt, 8));
  if (length > bytes.size())
    refuse(fmt::format("a state cut short, {} bytes", bytes.size()),
           fmt::format("the whole file, {} bytes", length));
  if (length < bytes.size())
    refuse(fmt::format("{} bytes", bytes.size()), fmt::format("a state that ends after {}", length));
  if (little_endian<std::uint64_t>(bytes.subspan(kChecksumAt, 8)) != checksum(bytes))
    refuse("a damaged state: its checksum is another", "the file as it was written");
  const auto hash = little_endian<std::uint64_t>(bytes.subspan(kHashAt, 8));
  if (hash != owner.motion_hash)
    refuse(fmt::format(
               "a state of another scene, or of this one with other maps, settings or seed (hash {:016x})",
               hash),
           fmt::format("one of this scene as it is (hash {:016x})", owner.motion_hash));
  return bytes.subspan(kStateHeaderBytes);
}

}  // namespace

std::vector<std::byte> state_bytes(const WorldState& state, const StateOwner& owner) {
  std::uint64_t size = kStateHeaderBytes;
  StateWriter counter([&](auto number) { size += sizeof(number); });
  visit_state(counter, owner.treading, state);
  if (size > kMostStateBytes)
    throw OverBudget("", "state", fmt::format("{} bytes", size), fmt::format("at most {}", kMostStateBytes));

  std::vector<std::byte> bytes(size);
  std::span<std::byte> rest(bytes);
  StateWriter writer([&](auto number) {
    put_little_endian(rest.first(sizeof(number)), number);
    rest = rest.subspan(sizeof(number));
  });
  for (const std::uint8_t byte : kMagic) writer.number(byte);
  visit_fields(writer, kVersion, kUnsealed, kUnsealed, owner.motion_hash);
  visit_state(writer, owner.treading, state);
  assert(rest.empty());
  seal_state(bytes);
  return bytes;
}

WorldState parse_state(std::span<const std::byte> bytes, const StateOwner& owner, const std::string& file) {
  const double spacing_m = owner.treading.spacing_m;
  WorldState state{{0, {0.0, NodeField<TreadNode>(spacing_m), NodeField<float>(spacing_m)}, {}, {}, {}}, {}};
  StateReader reader(checked_body(bytes, owner, file), file);
  visit_state(reader, owner.treading, state);
  reader.end();
  state.motion.treading.time_s = seconds_of(state.motion.ticks);
  return state;
}

void seal_state(std::span<std::byte> bytes) {
  assert(bytes.size() >= kStateHeaderBytes);
  put_little_endian(bytes.subspan(kLengthAt, 8), std::uint64_t{bytes.size()});
  put_little_endian(bytes.subspan(kChecksumAt, 8), checksum(bytes));
}

}  // namespace prairie
