#include "app/viewer/overlay.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <cstdint>
#include <glm/trigonometric.hpp>

#include "app/viewer/frame_choices.h"

namespace prairie {
namespace {

constexpr const char* kGlslVersion = "#version 450 core";
constexpr float kMarginPx = 10.0f;
constexpr float kBackgroundOpacity = 0.6f;  // readable before a white sky
constexpr float kSliderWidthPx = 150.0f;
constexpr const char* kKeys =
    "WASD QE shift: move   drag: turn   F: walk/fly   Esc: end\n"
    "T: tier   G: tint tiers   - =: quality   M: smooth edges   F12: picture   H: hide\n"
    "P: pause   N: step   [ ] , . ; ': wind   B: gust   V: tornado\n"
    "R: stone   C: cart   O: fields";
constexpr const char* kWalkerKeys =
    "K: watch the next walker   J: free, follow, orbit   X: what walkers perceive, paths\n"
    "U: steer it or give it back   arrows, shift: walk, turn   wheel, QE: nearer, farther";
constexpr const char* kCartKeys = "arrows: drive the cart";

void line(const std::string& text) {
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

std::string grouped(std::uint64_t number) {
  return fmt::format("{}", fmt::group_digits(number));
}

void tier_line(const char* name, std::uint64_t blades, std::uint64_t triangles) {
  line(fmt::format("{:<8}{:>14}{:>14}", name, grouped(blades), grouped(triangles)));
}

void statistics_lines(const FrameStatistics& statistics) {
  line(fmt::format("{:<8}{:>14}{:>14}", "", "blades", "triangles"));
  tier_line("spline", statistics.spline.blades, statistics.spline.triangles);
  tier_line("hermite", statistics.hermite.blades, statistics.hermite.triangles);
  tier_line("strip", statistics.strip.blades, statistics.strip.triangles);
  tier_line("flat", statistics.flat.blades, statistics.flat.triangles);
  tier_line("drawn", statistics.blades_drawn, statistics.triangles);
  std::string gpu;
  for (const StageTime& stage : statistics.gpu_times)
    gpu += fmt::format("   {} {:.2f} ms", stage.name, stage.ms);
  if (!gpu.empty()) line("GPU" + gpu);
}

void quality_slider(Quality& quality) {
  int step = static_cast<int>(quality);
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderInt("quality", &step, static_cast<int>(Quality::kLow), static_cast<int>(Quality::kHigh),
                   quality_name(quality), ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  quality = static_cast<Quality>(step);
}

void wind_sliders(WindControls& wind) {
  constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderFloat("wind", &wind.speed_m_per_s, 0.0f, WindControls::kMostSpeedMPerS, "%.1f m/s", kFlags);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderFloat("towards", &wind.heading_deg, 0.0f, 360.0f, "%.0f deg", kFlags);
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderFloat("turbulence", &wind.turbulence, 0.0f, WindControls::kMostTurbulence, "%.2f", kFlags);
}

/// The key whose button was pressed, or 0.
int key_buttons(const OverlayText& text) {
  int pressed = 0;
  const auto button = [&](const char* name, int key) {
    if (ImGui::SmallButton(name)) pressed = key;
    ImGui::SameLine();
  };
  button(text.paused ? "go on" : "pause", GLFW_KEY_P);
  if (text.paused) button("step", GLFW_KEY_N);
  button("gust", GLFW_KEY_B);
  button("tornado", GLFW_KEY_V);
  button("stone", GLFW_KEY_R);
  button("fields", GLFW_KEY_O);
  button(text.has_cart ? "leave cart" : "cart", GLFW_KEY_C);
  ImGui::NewLine();
  if (text.walkers.empty()) return pressed;
  button("next walker", GLFW_KEY_K);
  button("camera", GLFW_KEY_J);
  button("steer", GLFW_KEY_U);
  button("sensors and paths", GLFW_KEY_X);
  ImGui::NewLine();
  return pressed;
}

}  // namespace

Overlay::Overlay(GLFWwindow* window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leaves no file in the caller's folder
  ImGui::StyleColorsDark();
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init(kGlslVersion);
}

Overlay::~Overlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

int Overlay::draw(const OverlayText& text, OverlaySliders& sliders) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({kMarginPx, kMarginPx});
  ImGui::SetNextWindowBgAlpha(kBackgroundOpacity);
  ImGui::Begin("prairie", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  line(fmt::format("{:6.1f} ms   plan {:.2f} ms   {} x {}   tier {}{}", text.frame_ms,
                   text.statistics.plan_ms, text.camera.size_px.x, text.camera.size_px.y, text.tier,
                   text.tinted ? ", tinted" : ""));
  statistics_lines(text.statistics);
  line(fmt::format("{}   {:.2f},{:.2f},{:.2f},{:.1f},{:.1f}", text.movement, text.camera.eye_m.x,
                   text.camera.eye_m.y, text.camera.eye_m.z, glm::degrees(text.camera.yaw_rad),
                   glm::degrees(text.camera.pitch_rad)));
  line(fmt::format("{:.2f} s{}   step {:.1f} ms   {} blades touched", text.time_s,
                   text.paused ? ", paused" : "", text.steps_ms, grouped(text.touched_blades)));
  if (!text.walkers.empty()) line(text.walkers);
  quality_slider(sliders.quality);
  wind_sliders(sliders.wind);
  const int pressed = key_buttons(text);
  if (text.field != FieldOverlay::kNone) line(fmt::format("field: {}", overlay_name(text.field)));
  line(text.notice.empty() ? kKeys : text.notice);
  if (text.notice.empty() && !text.walkers.empty()) line(kWalkerKeys);
  if (text.has_cart) line(kCartKeys);
  ImGui::End();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  return pressed;
}

bool Overlay::wants_mouse() const {
  return ImGui::GetIO().WantCaptureMouse;
}

}  // namespace prairie
