// How much a person asks of the picture; lod/thinning.h turns it into coefficients.
#pragma once

namespace prairie {

enum class Quality { kLow, kMedium, kHigh };

}  // namespace prairie
