// Well-formed inputs to start mutations from, made anew for each run.
#pragma once

#include <cstdint>
#include <vector>

namespace prairie::fuzz {

using Input = std::vector<std::uint8_t>;

/// Defined once per fuzz target, in corpus_TARGET.cpp.
std::vector<Input> make_corpus();

/// How many mutated inputs one replay runs.
int replay_count();

}  // namespace prairie::fuzz
