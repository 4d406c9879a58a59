#include "app/viewer/panel_backend.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace prairie {
namespace {

constexpr const char* kGlslVersion = "#version 450 core";
constexpr float kMarginPx = 10.0f;
constexpr float kBackgroundOpacity = 0.6f;  // readable before a white sky

void draw_window(const PanelWindow& window, PanelInput& input) {
  const ImVec2 size_px = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({kMarginPx + window.corner.x * (size_px.x - 2.0f * kMarginPx),
                           kMarginPx + window.corner.y * (size_px.y - 2.0f * kMarginPx)},
                          ImGuiCond_Always, {window.corner.x, window.corner.y});
  ImGui::SetNextWindowBgAlpha(kBackgroundOpacity);
  ImGui::Begin(window.title.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  for (const Panel& panel : window.panels) panel(input);
  ImGui::End();
}

}  // namespace

PanelBackend::PanelBackend(GLFWwindow* window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leaves no file in the caller's folder
  ImGui::StyleColorsDark();
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init(kGlslVersion);
}

PanelBackend::~PanelBackend() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void PanelBackend::draw(const std::vector<PanelWindow>& windows, PanelInput& input) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  for (const PanelWindow& window : windows) draw_window(window, input);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool PanelBackend::wants_mouse() const {
  return ImGui::GetIO().WantCaptureMouse;
}

}  // namespace prairie
