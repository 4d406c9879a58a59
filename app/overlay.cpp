#include "app/overlay.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <glm/trigonometric.hpp>

namespace prairie {
namespace {

constexpr const char* kGlslVersion = "#version 450 core";
constexpr float kMarginPx = 10.0f;
constexpr float kBackgroundOpacity = 0.35f;
constexpr const char* kKeys =
    "WASD QE shift: move   drag: turn   F: walk/fly   T: tier   F12: picture   H: hide   Esc";

void line(const std::string& text) {
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
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

void Overlay::draw(const OverlayText& text) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({kMarginPx, kMarginPx});
  ImGui::SetNextWindowBgAlpha(kBackgroundOpacity);
  ImGui::Begin("prairie", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoNav);
  line(fmt::format("{:6.1f} ms   {} blades   {} triangles   {}", text.frame_ms, text.blades_drawn,
                   text.triangles, text.tier));
  line(fmt::format("{}   {:.2f},{:.2f},{:.2f},{:.1f},{:.1f}", text.walks ? "walking" : "flying",
                   text.camera.eye_m.x, text.camera.eye_m.y, text.camera.eye_m.z,
                   glm::degrees(text.camera.yaw_rad), glm::degrees(text.camera.pitch_rad)));
  line(text.notice.empty() ? kKeys : text.notice);
  ImGui::End();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace prairie
