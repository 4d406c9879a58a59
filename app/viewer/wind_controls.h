// The steady wind as a person sets it at a window, by keys or sliders.
#pragma once

namespace prairie {

class World;
struct Scene;
struct Wind;

struct WindControls {
  float speed_m_per_s = 0.0f;  // 0…kMostSpeedMPerS
  float heading_deg = 90.0f;   // towards which it blows, clockwise from north, 0…360
  float turbulence = 1.0f;     // factor on the noise, 0…kMostTurbulence

  static constexpr float kMostSpeedMPerS = 30.0f;
  static constexpr float kMostTurbulence = 3.0f;

  bool operator==(const WindControls&) const = default;
};

/// What the scene says; of a measured wind, its velocity at the beginning.
WindControls wind_controls_of(const Scene& scene, const Wind& wind);

/// By steps of 1 m/s, 15° and a quarter of what is usual. Speed and turbulence stay in range; headings go
/// round.
void change_speed(WindControls& controls, int steps);
void change_heading(WindControls& controls, int steps);
void change_turbulence(WindControls& controls, int steps);

/// From now on that wind blows; its turbulence drifts on from where it is.
void blow(const WindControls& controls, World& world);

}  // namespace prairie
