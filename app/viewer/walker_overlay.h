// What walkers perceive and where they were, as lines over the picture (G03 fig. 5): around each a red circle
// as far as its sensor reaches, a red line to the nearest obstacle inside it, and its path of the last
// minute. No OpenGL.
//
// A sensor measures from edge to edge, so the circle is a sensor range away from the body's edge. Lines lie 5
// cm above the ground and follow it.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "agents/behaviour.h"
#include "app/viewer/walker_trails.h"
#include "render/overlays/line_segment.h"

namespace prairie {

class World;

enum class WalkerOverlay { kNone, kSensors, kPaths, kBoth };

/// "none", "sensors", "paths" or "sensors and paths".
const char* walker_overlay_name(WalkerOverlay overlay);
WalkerOverlay next_walker_overlay(WalkerOverlay overlay);
bool shows_sensors(WalkerOverlay overlay);
bool shows_paths(WalkerOverlay overlay);

inline constexpr double kLineAboveGroundM = 0.05;
inline constexpr std::size_t kCircleSegments = 36;

/// Of the walkers nearest to the eye, at most kMostOverlaidWalkers. `percepts`: of all, as World::percepts()
/// has them; those who replay tracks have none, and no circle.
std::vector<LineSegment> sensor_lines(const World& world, std::span<const Percept> percepts,
                                      glm::dvec3 eye_m);

/// Up to where the same walkers are now, the older the fainter.
std::vector<LineSegment> path_lines(const World& world, const WalkerTrails& trails, glm::dvec3 eye_m);

}  // namespace prairie
