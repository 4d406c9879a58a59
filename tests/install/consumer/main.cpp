// Steps a world and counts what grows on its first tile.
#include <cstdio>

#include "generator/plant.h"
#include "world/scene/scene.h"
#include "world/world.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  prairie::World world(prairie::read_scene(argv[1], {}), {});
  for (int step = 0; step < 60; ++step) world.step(1.0 / 60.0);
  const std::size_t blades = prairie::plant_tile(world.meadow(), {0, 0}).size();
  std::printf("%.3f s, %zu blades\n", world.time_s(), blades);
  return blades > 0 && world.time_s() > 0.9 ? 0 : 1;
}
