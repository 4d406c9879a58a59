#include "world/state_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "files/error.h"
#include "files/little_endian.h"
#include "world/motion.h"

namespace prairie {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'P', 'R', 'S', '\r', '\n', 0x1a, '\n'};
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kVersionAt = 8, kLengthAt = 12, kChecksumAt = 20, kHashAt = 28;
static_assert(kHashAt + 8 == kStateHeaderBytes);

constexpr std::size_t kNodesPerPage = std::size_t{kPageNodes} * kPageNodes;
constexpr std::size_t kNodeBytes = 8 + 5 * 4;
constexpr std::size_t kTreadPageBytes = 8 + kNodesPerPage * kNodeBytes;
constexpr std::size_t kWearPageBytes = 8 + kNodesPerPage * 4;
constexpr std::size_t kMotionBytes = 24 * 4;
constexpr std::size_t kCellBytes = 4 * 4;
constexpr std::size_t kBladeBytes = 4 + kMotionBytes + 2 * 12 * 4 + 3 * 4;
constexpr std::size_t kFootBytes = 6 * 8 + 4;
constexpr std::size_t kWalkerBytes = 5 * 8 + 3 * 8 + 2 * kFootBytes + 4 + 8 + 4 + 5 * 8;
constexpr std::size_t kSettingsBytes = 3 * 8 + 6 * 4;

std::uint64_t checksum(std::span<const std::byte> bytes) {
  const std::span<const std::byte> rest = bytes.subspan(kHashAt);
  return XXH3_64bits(rest.data(), rest.size());
}

std::uint64_t size_of(const WorldState& world) {
  const MotionState& state = world.motion;
  std::uint64_t size = kStateHeaderBytes + 8 + kSettingsBytes + 8 + 8 + 4 + 4 + 8 + 8;
  size += world.walkers.size() * kWalkerBytes;
  size += state.treading.nodes.pages().size() * kTreadPageBytes +
          state.treading.wear.pages().size() * kWearPageBytes;
  if (state.eye_m) size += 16;
  if (state.sway) size += 8 + state.sway->motions.size() * kMotionBytes;
  for (const auto& [id, blades] : state.touched) size += kCellBytes + blades.size() * kBladeBytes;
  return size;
}

class Writer {
 public:
  explicit Writer(std::uint64_t size) { bytes_.reserve(size); }

  template <FixedWidth... Numbers>
  void put(Numbers... numbers) {
    (append_little_endian(bytes_, numbers), ...);
  }
  void put_count(std::size_t count) { put(std::uint64_t{count}); }
  void put_flag(bool flag) { put(std::uint32_t{flag}); }
  void put_vectors(const ChainVectors& vectors) {
    for (const glm::vec3& v : {vectors.v1, vectors.v2, vectors.v3, vectors.v4}) put(v.x, v.y, v.z);
  }
  void put_motion(const ChainMotion& motion) {
    put_vectors(motion.turn);
    put_vectors(motion.rate);
  }

  void put_place(glm::dvec2 place) { put(place.x, place.y); }
  void put_walker(const Walker& walker) {
    put_place(walker.position_m);
    put_place(walker.forward);
    put(walker.speed_m_per_s, walker.footing.scale, walker.footing.phase, walker.footing.speed_m_per_s);
    for (const Foot& foot : walker.footing.feet) {
      put_place(foot.position_m);
      put_place(foot.forward);
      put_flag(foot.planted);
      put(foot.share, foot.lift_phase);
    }
    const Memory& memory = walker.memory;
    put(memory.turn, memory.turned_s, memory.goal, memory.goal_since_s, memory.met_m, memory.met_s,
        memory.moved_s, memory.backs_off_until_s);
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  Reader(std::span<const std::byte> bytes, const std::string& file) : rest_(bytes), file_(file) {}

  /// `section`: what an error names.
  void enter(const char* section) { section_ = section; }

  template <FixedWidth Number>
  Number number() {
    if (rest_.size() < sizeof(Number)) refuse(fmt::format("{} bytes left", rest_.size()), "a number");
    const auto result = little_endian<Number>(rest_.first(sizeof(Number)));
    rest_ = rest_.subspan(sizeof(Number));
    if constexpr (std::floating_point<Number>) {
      if (!std::isfinite(result)) refuse(fmt::format("{}", result), "finite numbers");
    }
    return result;
  }

  /// Of things that take at least so many bytes each.
  template <FixedWidth Number>
  std::size_t count(std::size_t bytes_each) {
    const auto count = number<Number>();
    if (count > rest_.size() / bytes_each)
      refuse(fmt::format("a count of {} with {} bytes left", count, rest_.size()),
             fmt::format("at most {}", rest_.size() / bytes_each));
    return static_cast<std::size_t>(count);
  }

  bool flag() {
    const auto flag = number<std::uint32_t>();
    if (flag > 1) refuse(fmt::format("{}", flag), "0 or 1");
    return flag == 1;
  }

  glm::vec3 vector() {
    const auto x = number<float>(), y = number<float>(), z = number<float>();
    return {x, y, z};
  }
  ChainVectors vectors() {
    ChainVectors vectors;
    for (glm::vec3* v : {&vectors.v1, &vectors.v2, &vectors.v3, &vectors.v4}) *v = vector();
    return vectors;
  }
  ChainMotion motion() {
    ChainMotion motion;
    motion.turn = vectors();
    motion.rate = vectors();
    return motion;
  }

  glm::dvec2 place() {
    const auto x = number<double>(), y = number<double>();
    return {x, y};
  }
  Walker walker() {
    Walker walker;
    walker.position_m = place();
    walker.forward = place();
    walker.speed_m_per_s = number<double>();
    walker.footing.scale = number<double>();
    walker.footing.phase = number<double>();
    walker.footing.speed_m_per_s = number<double>();
    for (Foot& foot : walker.footing.feet) {
      foot.position_m = place();
      foot.forward = place();
      foot.planted = flag();
      foot.share = number<double>();
      foot.lift_phase = number<double>();
    }
    Memory& memory = walker.memory;
    memory.turn = number<std::int32_t>();
    memory.turned_s = number<double>();
    memory.goal = number<std::int32_t>();
    for (double* value :
         {&memory.goal_since_s, &memory.met_m, &memory.met_s, &memory.moved_s, &memory.backs_off_until_s})
      *value = number<double>();
    return walker;
  }

  void end() const {
    if (!rest_.empty()) refuse(fmt::format("{} more bytes", rest_.size()), "the end of the file");
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw BadInput(file_, section_, found, expected);
  }

 private:
  std::span<const std::byte> rest_;
  const std::string& file_;
  const char* section_ = "";
};

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

void check_settings(Reader& reader, const TreadSettings& settings) {
  reader.enter("treading");
  const auto expect = [&](const char* name, auto value) {
    const auto found = reader.number<decltype(value)>();
    if (found != value)
      reader.refuse(fmt::format("{} {}", name, found), fmt::format("{}, the scene's", value));
  };
  expect("spacing_m", settings.spacing_m);
  expect("reach_radii", settings.reach_radii);
  expect("recovery_s", settings.recovery_s);
  expect("field_scale", settings.field_scale);
  expect("most_tilt_rad", settings.most_tilt_rad);
  expect("load_slowing", settings.load_slowing);
  expect("worn_slowing", settings.worn_slowing);
  expect("wear_passes", settings.wear_passes);
  expect("worn_field", settings.worn_field);
}

/// Calls `read(node)` for each node of each page.
template <class Node, class Read>
void read_pages(Reader& reader, std::size_t page_bytes, NodeField<Node>& field, Read read) {
  std::optional<PageIndex> last;
  for (std::size_t left = reader.count<std::uint64_t>(page_bytes); left > 0; --left) {
    PageIndex index;
    index.j = reader.number<std::int32_t>();
    index.i = reader.number<std::int32_t>();
    if (last && !(*last < index))
      reader.refuse("pages out of order or twice", "each once, from south to north");
    last = index;
    for (Node& node : field.touch_page(index)) read(node);
  }
}

std::vector<TouchedBlade> read_blades(Reader& reader) {
  std::vector<TouchedBlade> blades(reader.count<std::uint32_t>(kBladeBytes));
  for (TouchedBlade& blade : blades) {
    blade.index = reader.number<std::uint32_t>();
    blade.motion = reader.motion();
    blade.rest = reader.vectors();
    blade.offset = reader.vectors();
    blade.rise = reader.number<float>();
    blade.near_steps = reader.number<std::int32_t>();
    blade.fades = reader.number<std::int32_t>();
  }
  return blades;
}

}  // namespace

std::vector<std::byte> state_bytes(const WorldState& world, const StateOwner& owner) {
  const MotionState& state = world.motion;
  const std::uint64_t size = size_of(world);
  if (size > kMostStateBytes)
    throw OverBudget("", "state", fmt::format("{} bytes", size), fmt::format("at most {}", kMostStateBytes));
  Writer writer(size);
  for (const std::uint8_t byte : kMagic) writer.put(byte);
  writer.put(kVersion, std::uint64_t{0}, std::uint64_t{0}, owner.motion_hash);
  writer.put(state.ticks);
  const TreadSettings& s = owner.treading;
  writer.put(s.spacing_m, s.reach_radii, s.recovery_s, s.field_scale, s.most_tilt_rad, s.load_slowing,
             s.worn_slowing, s.wear_passes, s.worn_field);
  writer.put_count(state.treading.nodes.pages().size());
  for (const auto& [page, nodes] : state.treading.nodes.pages()) {
    writer.put(std::int32_t{page.j}, std::int32_t{page.i});
    for (const TreadNode& node : nodes)
      writer.put(node.start_s, node.field, node.recovery_s, node.blades_recovery_s, node.direction.x,
                 node.direction.y);
  }
  writer.put_count(state.treading.wear.pages().size());
  for (const auto& [page, wear] : state.treading.wear.pages()) {
    writer.put(std::int32_t{page.j}, std::int32_t{page.i});
    for (const float value : wear) writer.put(value);
  }
  writer.put_flag(state.eye_m.has_value());
  if (state.eye_m) writer.put_place(*state.eye_m);
  writer.put_flag(state.sway.has_value());
  if (state.sway) {
    writer.put_count(state.sway->motions.size());
    for (const ChainMotion& motion : state.sway->motions) writer.put_motion(motion);
  }
  writer.put_count(world.walkers.size());
  for (const Walker& walker : world.walkers) writer.put_walker(walker);
  writer.put_count(state.touched.size());
  for (const auto& [id, blades] : state.touched) {
    writer.put(std::int32_t{id.tile.i}, std::int32_t{id.tile.j}, std::int32_t{id.cell},
               static_cast<std::uint32_t>(blades.size()));
    for (const TouchedBlade& blade : blades) {
      writer.put(blade.index);
      writer.put_motion(blade.motion);
      writer.put_vectors(blade.rest);
      writer.put_vectors(blade.offset);
      writer.put(blade.rise, blade.near_steps, blade.fades);
    }
  }
  std::vector<std::byte> bytes = writer.take();
  assert(bytes.size() == size);
  seal_state(bytes);
  return bytes;
}

WorldState parse_state(std::span<const std::byte> bytes, const StateOwner& owner, const std::string& file) {
  Reader reader(checked_body(bytes, owner, file), file);
  reader.enter("time");
  const auto ticks = reader.number<std::int64_t>();
  check_settings(reader, owner.treading);
  const double spacing_m = owner.treading.spacing_m;
  WorldState world{
      {ticks, {seconds_of(ticks), NodeField<TreadNode>(spacing_m), NodeField<float>(spacing_m)}, {}, {}, {}},
      {}};
  MotionState& state = world.motion;

  reader.enter("trodden");
  read_pages(reader, kTreadPageBytes, state.treading.nodes, [&](TreadNode& node) {
    node.start_s = reader.number<double>();
    for (float* number :
         {&node.field, &node.recovery_s, &node.blades_recovery_s, &node.direction.x, &node.direction.y})
      *number = reader.number<float>();
  });
  reader.enter("worn");
  read_pages(reader, kWearPageBytes, state.treading.wear,
             [&](float& wear) { wear = reader.number<float>(); });

  reader.enter("eye");
  if (reader.flag()) state.eye_m = reader.place();
  reader.enter("sway");
  if (reader.flag()) {
    if (!state.eye_m) reader.refuse("swaying blades without an eye", "an eye that watches them");
    SwayState& sway = state.sway.emplace();
    sway.centre_m = *state.eye_m;
    sway.motions.resize(reader.count<std::uint64_t>(kMotionBytes));
    for (ChainMotion& motion : sway.motions) motion = reader.motion();
  }
  reader.enter("walkers");
  world.walkers.resize(reader.count<std::uint64_t>(kWalkerBytes));
  for (Walker& walker : world.walkers) walker = reader.walker();
  reader.enter("touched");
  const std::size_t cells = reader.count<std::uint64_t>(kCellBytes + kBladeBytes);
  state.touched.reserve(cells);
  while (state.touched.size() < cells) {
    CellId id;
    id.tile.i = reader.number<std::int32_t>();
    id.tile.j = reader.number<std::int32_t>();
    id.cell = reader.number<std::int32_t>();
    state.touched.emplace_back(id, read_blades(reader));
  }
  reader.end();
  return world;
}

void seal_state(std::span<std::byte> bytes) {
  assert(bytes.size() >= kStateHeaderBytes);
  put_little_endian(bytes.subspan(kLengthAt, 8), std::uint64_t{bytes.size()});
  put_little_endian(bytes.subspan(kChecksumAt, 8), checksum(bytes));
}

}  // namespace prairie
