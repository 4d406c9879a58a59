// The axes of the tables of a sward's look (lod/sward/sward_response.h).

const int kSwardElevations = 16;
const int kSwardAzimuths = 9;
const int kSwardDepths = 12;
const float kSwardLowestSine = 0.003f;  // of the elevation at the first node
const float kSwardDeepest = 300.0f;     // optical depth at the last node
