#include "tests/fuzz/corpus.h"
#include "tests/fuzz/state_worlds.h"
#include "world/motion.h"
#include "world/state_file.h"

namespace prairie::fuzz {

int replay_count() {
  return 30000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  const auto add = [&](std::span<const std::byte> bytes, StateInput kind) {
    Input input{static_cast<Input::value_type>(kind)};
    for (const std::byte byte : bytes) input.push_back(std::to_integer<Input::value_type>(byte));
    corpus.push_back(std::move(input));
  };
  World world = calm_world();
  for (const int steps : {0, 20, 100}) {
    for (int n = 0; n < steps; ++n) world.step(1.0 / 60.0);
    const std::vector<std::byte> bytes = world.saved_state();
    add(bytes, StateInput::kFile);
    add(std::span(bytes).subspan(kStateHeaderBytes), StateInput::kBody);
    world.motion().watch({3.0, 3.0});
  }
  // Nothing trodden, but blades that move.
  MotionState state = world.motion().state();
  const double spacing_m = world.scene().treading.spacing_m;
  state.treading.nodes = NodeField<TreadNode>(spacing_m);
  state.treading.wear = NodeField<float>(spacing_m);
  const std::vector<std::byte> bytes =
      state_bytes({state, {}}, {world.motion_hash(), world.scene().treading});
  add(std::span(bytes).subspan(kStateHeaderBytes), StateInput::kBody);
  return corpus;
}

}  // namespace prairie::fuzz
