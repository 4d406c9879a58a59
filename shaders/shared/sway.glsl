// Windows of the moving fields around the eye, as tori of texels of rising size (animation/eye_windows.h,
// animation/tread_window.h).

const int kSwayLevels = 3;
const int kSwaySide = 64;            // texels of a window's side
const float kSwayFinestM = 1.0f;     // side of a texel of the finest level;
const float kSwayCoarsening = 4.0f;  // of the next, in those of the last
const float kSwayPeriodS = 1024.0f;  // after which blades' own swaying repeats
const int kTreadLevels = 2;          // windows as wide as the first of the above
const int kTreadSide = 512;
const float kTreadMostRad = 1.6f;  // the treads' texels hold angles as shares of this
