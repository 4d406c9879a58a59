// Runs a fuzz target without libFuzzer: every input of the corpus as it is, then deterministic mutations of
// them. Takes files as arguments too, to look at a finding again. `--runs N` makes more mutations,
// `--write-corpus FOLDER` gives libFuzzer something to start from.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>

#include "tests/fuzz/corpus.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using prairie::fuzz::Input;

void run(const Input& input) {
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

/// Overwrites, swaps, drops or doubles a few bytes; more often near the start, where the headers are.
Input mutated(Input input, std::mt19937& random) {
  constexpr std::uint8_t kTelling[] = {0x00, 0x01, 0x7f, 0x80, 0xff};
  const std::uint_fast32_t edits = 1 + random() % 6;
  for (std::uint_fast32_t edit = 0; edit < edits && !input.empty(); ++edit) {
    const std::size_t reach = random() % 2 == 0 ? std::min<std::size_t>(input.size(), 400) : input.size();
    const std::size_t at = random() % reach;
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random() % 6) {
      case 0:
        input[at] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        input[at] = kTelling[random() % std::size(kTelling)];
        break;
      case 2:
        input[at] = static_cast<std::uint8_t>(input[at] ^ (1u << random() % 8));
        break;
      case 3:
        for (std::size_t k = at; k < std::min(at + 4, input.size()); ++k) {
          input[k] = kTelling[random() % std::size(kTelling)];
        }
        break;
      case 4:
        if (random() % 4 == 0) input.resize(at);
        break;
      case 5:
        input.insert(place, 1 + random() % 4, *place);
        break;
    }
  }
  return input;
}

Input read(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  return Input((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<Input> corpus = prairie::fuzz::make_corpus();
  if (count == 3 && std::string_view(arguments[1]) == "--write-corpus") {
    for (std::size_t k = 0; k < corpus.size(); ++k) {
      std::ofstream stream(std::filesystem::path(arguments[2]) / std::to_string(k), std::ios::binary);
      stream.write(reinterpret_cast<const char*>(corpus[k].data()),
                   static_cast<std::streamsize>(corpus[k].size()));
    }
    return 0;
  }
  long runs = prairie::fuzz::replay_count();
  if (count == 3 && std::string_view(arguments[1]) == "--runs") {
    runs = std::stol(arguments[2]);
  } else if (count > 1) {
    for (int k = 1; k < count; ++k) run(read(arguments[k]));
    return 0;
  }
  for (const Input& input : corpus) run(input);
  std::mt19937 random(20031);
  for (long k = 0; k < runs; ++k) run(mutated(corpus[random() % corpus.size()], random));
  std::printf("%zu inputs and %ld mutations\n", corpus.size(), runs);
}
