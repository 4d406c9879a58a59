// The strips' texture holds radiance as a share of its row's mean, up to this much.
const float kBrightest = 5.0f;
