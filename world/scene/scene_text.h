// A scene as its file has it: the text that reads back as the same scene.
#pragma once

#include <map>
#include <string>

#include "world/scene/scene.h"

namespace prairie {

/// Notes for people who will edit the text, by dotted keys ("species", "species.height_m"). What a scene has
/// several of is noted with its first.
struct SceneNotes {
  std::string head;                             // before everything else
  std::map<std::string, std::string> sections;  // above a section
  std::map<std::string, std::string> above;     // above a key
  /// Behind a key, which is then written even where it has its default; may be empty.
  std::map<std::string, std::string> keys;
  std::map<std::string, std::string> below;  // under a section's keys
};

/// TOML: what is not as it would be without a word, and what has a note. Notes are whole lines of comment but
/// those behind a key, which get their '#' here.
std::string scene_text(const Scene& scene, const SceneNotes& notes = {});

}  // namespace prairie
