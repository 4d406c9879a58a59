#include "world/decoder.h"

#include "files/fallible_work.h"
#include "maps/map_work.h"

namespace prairie {

Work decoding_work() {
  return fallible(chosen_by_name(map_works()));
}

}  // namespace prairie
