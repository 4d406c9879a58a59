// The tables of keys against the scene that sets them all, against overrides and against the manual.
#include "world/scene/scene_keys.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "tests/world/scene/every_key.h"
#include "tests/world/scene/set_keys.h"
#include "world/scene/key_table.h"

namespace prairie {
namespace {

struct KnownKey {
  std::string section;
  KeyTraits traits;
  std::string default_text;  // empty: none
};

template <class Section>
void add(std::vector<KnownKey>& known, const std::string& section, const KeyTable<Section>& table,
         const Section& defaults = {}) {
  for (const Key<Section>& key : table.keys) {
    if (key.traits.name.empty()) continue;
    const bool has_default = !key.traits.is_required;
    known.push_back(
        {section, key.traits, has_default ? key.text(key.traits, Scene{}, defaults) : std::string()});
  }
}

std::vector<KnownKey> all_keys() {
  std::vector<KnownKey> known;
  add(known, "", top_keys(), Scene{});
  add(known, "height", map_keys(MapUse::kHeight));
  add(known, "ground", ground_keys(), Scene{});
  add(known, "species", species_keys(), default_species());
  add(known, "species.density", map_keys(MapUse::kDensity));
  add(known, "maps.blade_height", map_keys(MapUse::kFactor));
  add(known, "maps.bend", map_keys(MapUse::kFactor));
  add(known, "maps.color", map_keys(MapUse::kColor));
  add(known, "camera", camera_keys());
  add(known, "sun", sun_keys());
  add(known, "sky", sky_keys());
  add(known, "lod", lod_keys());
  add(known, "wind", wind_keys());
  add(known, "wind.gust", gust_keys());
  add(known, "wind.tornado", tornado_keys());
  add(known, "wind.breeze", breeze_keys());
  add(known, "condition", condition_keys());
  add(known, "treading", treading_keys());
  add(known, "mover", mover_keys());
  add(known, "obstacle", trunk_keys());
  add(known, "obstacle", box_keys());
  add(known, "obstacle", rock_keys());
  add(known, "wall", wall_keys());
  add(known, "goal", goal_keys());
  add(known, "walkers", walkers_keys());
  return known;
}

TEST(SceneKeys, AreAllSetByTheScenesThatSetEveryKey) {
  std::set<std::pair<std::string, std::string>> set;
  for (const char* text :
       {testing::kEveryKeyScene, testing::kExcludingKeysScene, testing::kForeignMapsScene}) {
    for (const testing::SetKey& key : testing::set_keys(text)) set.insert({key.section, key.key});
  }
  for (const KnownKey& known : all_keys()) {
    EXPECT_TRUE(set.contains({known.section, std::string(known.traits.name)}))
        << known.section << '.' << known.traits.name;
  }
}

bool is_required(const testing::SetKey& set) {
  if (set.key == "version" || set.key == "kind") return set.section != "mover";
  if (set.key == "goals") return true;  // for the behaviour of that scene
  const auto known = all_keys();
  return std::ranges::any_of(known, [&](const KnownKey& key) {
    return key.section == set.section && key.traits.name == set.key && key.traits.is_required;
  });
}

void expect_every_key_counts(const char* text, const std::set<std::string>& as_by_default) {
  const auto hash_of = [](const std::string& scene, const std::vector<std::string>& overrides) {
    return scene_hash(parse_scene(scene, "folder", overrides), testing::kEveryFile);
  };
  const std::uint64_t hash = hash_of(text, {});
  for (const testing::SetKey& key : testing::set_keys(text)) {
    EXPECT_EQ(hash_of(text, {key.path + "=" + key.value}), hash) << key.path;
    if (is_required(key)) continue;
    const std::string without = testing::without_line(text, key.line);
    EXPECT_EQ(hash_of(without, {}) == hash, as_by_default.contains(key.path)) << key.path;
    EXPECT_EQ(hash_of(without, {key.path + "=" + key.value}), hash) << key.path;
  }
}

TEST(SceneKeys, CountInTheHashAndCanBeOverridden) {
  // Maps repeat with the height map.
  expect_every_key_counts(testing::kEveryKeyScene, {"maps.bend.repeat", "maps.color.repeat"});
  expect_every_key_counts(testing::kForeignMapsScene, {});
}

TEST(SceneKeys, RequiredOnesAreMissed) {
  for (const testing::SetKey& key : testing::set_keys(testing::kEveryKeyScene)) {
    if (!is_required(key)) continue;
    const std::string without = testing::without_line(testing::kEveryKeyScene, key.line);
    EXPECT_THROW(parse_scene(without, "folder", {}), BadInput) << key.path;
  }
}

/// A row of a table of the manual, of one key.
struct Row {
  std::string key;
  std::vector<std::string> cells;
};

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0;;) {
    const auto to = text.find(separator, from);
    std::string part = text.substr(from, to == std::string::npos ? to : to - from);
    const auto first = part.find_first_not_of(' ');
    parts.push_back(first == std::string::npos ? ""
                                               : part.substr(first, part.find_last_not_of(' ') - first + 1));
    if (to == std::string::npos) return parts;
    from = to + separator.size();
  }
}

/// Rows tell of several keys at times, their defaults in the same order.
void add_rows(const std::string& line, std::vector<Row>& rows) {
  std::vector<std::string> cells = split(line.substr(1), "|");
  const std::vector<std::string> keys = split(cells[0], ","), defaults = split(cells[2], ",");
  for (std::size_t n = 0; n < keys.size(); ++n) {
    if (keys.size() > 1) cells[2] = defaults.at(n);
    rows.push_back({keys[n].substr(1, keys[n].size() - 2), cells});
  }
}

struct Manual {
  std::map<std::string, std::string> sections;  // whole texts by their heading
  std::map<std::string, std::vector<Row>> rows;
};

Manual manual() {
  Manual manual;
  std::ifstream file(std::filesystem::path(PRAIRIE_SOURCES) / "docs/scene-file.md");
  std::string heading;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) heading = line.substr(3);
    manual.sections[heading] += line + '\n';
    if (line.starts_with("| `")) add_rows(line, manual.rows[heading]);
  }
  return manual;
}

std::string heading_of(const std::string& section) {
  if (section.empty()) return "Top level";
  if (section == "sun" || section == "sky") return "sun and sky";
  if (section == "obstacle" || section == "wall") return "obstacle and wall";
  if (section == "goal") return "walkers";
  if (section == "species.density" || section == "height") return "How maps are read";
  return section.substr(0, section.find('.'));
}

TEST(SceneKeys, AreInTheManual) {
  const Manual book = manual();
  for (const KnownKey& key : all_keys()) {
    const std::string heading = heading_of(key.section);
    ASSERT_TRUE(book.sections.contains(heading)) << heading;
    const std::string name(key.traits.name);
    const std::string& text = book.sections.at(heading);
    const bool is_told = text.find('`' + name + '`') != std::string::npos ||
                         text.find('`' + key.section + '.' + name + '`') != std::string::npos;
    EXPECT_TRUE(is_told) << key.section << '.' << name << " in docs/scene-file.md, " << heading;
  }
}

/// A value in the manual's words or in TOML's, in one form: without quotes, blanks and needless zeros.
std::string plain(std::string text) {
  if (text == "\"#ffffff\"") return "[1,1,1]";
  std::erase_if(text, [](char c) { return c == '`' || c == '"' || c == ' '; });
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const bool is_number = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    std::size_t length = 1;
    if (is_number) {
      const double value = std::stod(text.substr(i), &length);
      result += fmt::format("{}", value);
    } else {
      result += text[i];
    }
    i += length;
  }
  return result;
}

/// What the manual says of a key's default: in a section's tables the same key may occur more than once.
std::vector<std::string> told_defaults(const Manual& book, const KnownKey& key) {
  const std::map<std::string, std::size_t> columns{
      {"treading", 1}, {"wind.gust", 1}, {"wind.tornado", 2}, {"wind.breeze", 3}};
  const auto column = columns.find(key.section);
  std::vector<std::string> cells;
  const auto rows = book.rows.find(heading_of(key.section));
  if (rows == book.rows.end()) return cells;
  for (const Row& row : rows->second) {
    if (row.key == key.traits.name || row.key == key.section + '.' + std::string(key.traits.name))
      cells.push_back(row.cells.at(column == columns.end() ? 2 : column->second));
  }
  return cells;
}

/// "3, at most `radius_m`" begins with the value; degrees of a round number of radians are told roundly.
bool is_told(const std::string& value, const std::string& cell) {
  const std::string expected = plain(value), told = plain(cell);
  if (told.starts_with(expected)) return true;
  char *end = nullptr, *told_end = nullptr;
  const double number = std::strtod(expected.c_str(), &end),
               told_number = std::strtod(told.c_str(), &told_end);
  constexpr double kRounding = 2e-3;
  return *end == 0 && *told_end == 0 && std::abs(number - told_number) < kRounding * std::abs(number);
}

TEST(SceneKeys, HaveTheDefaultsOfTheManual) {
  const Manual book = manual();
  int compared = 0;
  for (const KnownKey& key : all_keys()) {
    const std::vector<std::string> cells = told_defaults(book, key);
    // Maps repeat with the height map; goals have no table.
    if (key.traits.name == "repeat" || key.section == "goal") continue;
    if (cells.empty() || key.default_text.empty() || cells[0] == "–") continue;
    EXPECT_TRUE(std::ranges::any_of(cells, [&](const auto& cell) { return is_told(key.default_text, cell); }))
        << key.section << '.' << key.traits.name << ": " << cells[0] << " instead of " << key.default_text;
    ++compared;
  }
  EXPECT_GT(compared, 80);
}

}  // namespace
}  // namespace prairie
