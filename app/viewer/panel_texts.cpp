#include "app/viewer/panel_texts.h"

#include <fmt/format.h>

#include <cstdint>
#include <glm/trigonometric.hpp>

#include "app/terminal/option_values.h"
#include "app/viewer/frame_choices.h"
#include "app/viewer/walker_text.h"
#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

std::string grouped(std::uint64_t number) {
  return fmt::format("{}", fmt::group_digits(number));
}

std::string tier_line(const char* name, std::uint64_t blades, std::uint64_t triangles) {
  return fmt::format("{:<8}{:>14}{:>14}", name, grouped(blades), grouped(triangles));
}

std::string movement(const WalkerCamera& camera) {
  if (camera.mode() != CameraMode::kFree) return camera_mode_name(camera.mode());
  return camera.walks() ? "walking" : "flying";
}

}  // namespace

std::vector<std::string> statistics_lines(const Session& session, const DrawnFrame& frame) {
  const FrameStatistics& statistics = frame.statistics;
  const glm::ivec2 size_px = session.camera.camera().size_px;
  std::vector<std::string> lines{
      fmt::format("{:6.1f} ms   plan {:.2f} ms   {} x {}   tier {}{}", frame.median_ms, statistics.plan_ms,
                  size_px.x, size_px.y, tier_name(session.frame_options.tier),
                  session.frame_options.tier_tint ? ", tinted" : ""),
      fmt::format("{:<8}{:>14}{:>14}", "", "blades", "triangles"),
      tier_line("spline", statistics.spline.blades, statistics.spline.triangles),
      tier_line("hermite", statistics.hermite.blades, statistics.hermite.triangles),
      tier_line("strip", statistics.strip.blades, statistics.strip.triangles),
      tier_line("flat", statistics.flat.blades, statistics.flat.triangles),
      tier_line("drawn", statistics.blades_drawn, statistics.triangles)};
  std::string gpu;
  for (const StageTime& stage : statistics.gpu_times)
    gpu += fmt::format("   {} {:.2f} ms", stage.name, stage.ms);
  if (!gpu.empty()) lines.push_back("GPU" + gpu);
  return lines;
}

std::string camera_line(const Session& session) {
  const Camera& camera = session.camera.camera();
  return fmt::format("{}   {:.2f},{:.2f},{:.2f},{:.1f},{:.1f}", movement(session.camera), camera.eye_m.x,
                     camera.eye_m.y, camera.eye_m.z, glm::degrees(camera.yaw_rad),
                     glm::degrees(camera.pitch_rad));
}

std::string time_line(const Session& session) {
  return fmt::format("{:.2f} s{}   step {:.1f} ms   {} blades touched", session.world.time_s(),
                     session.play.paused() ? ", paused" : "", session.play.steps_ms(),
                     grouped(session.world.motion().touched().size()));
}

std::vector<std::string> walker_lines(const Session& session, const DrawnFrame& frame) {
  if (!session.has_walkers()) return {};
  std::string how_many = walkers_line(session.world);
  if (session.walker_overlay != WalkerOverlay::kNone)
    how_many += fmt::format("   {}", walker_overlay_name(session.walker_overlay));
  std::vector<std::string> lines{how_many};
  if (const auto watched = session.camera.watched())
    lines.push_back(watched_walker_line(session.world, *watched, frame.percepts));
  return lines;
}

std::string field_line(const Session& session) {
  const FieldOverlay field = session.frame_options.field_overlay;
  return field == FieldOverlay::kNone ? "" : fmt::format("field: {}", overlay_name(field));
}

}  // namespace prairie
