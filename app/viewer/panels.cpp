#include "app/viewer/panels.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/frame_choices.h"
#include "app/viewer/key_help.h"
#include "app/viewer/panel_texts.h"

namespace prairie {
namespace {

constexpr float kSliderWidthPx = 150.0f;
constexpr float kButtonRowPx = 600.0f;
constexpr ImGuiSliderFlags kSliderFlags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput;

void show(const std::string& text) {
  if (!text.empty()) ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void show(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) show(line);
}

Quality quality_slider(Quality quality) {
  int step = static_cast<int>(quality);
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderInt("quality", &step, static_cast<int>(Quality::kLow), static_cast<int>(Quality::kHigh),
                   quality_name(quality), kSliderFlags);
  return static_cast<Quality>(step);
}

WindControls wind_sliders(WindControls wind) {
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderFloat("wind", &wind.speed_m_per_s, 0.0f, WindControls::kMostSpeedMPerS, "%.1f m/s",
                     kSliderFlags);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderFloat("towards", &wind.heading_deg, 0.0f, 360.0f, "%.0f deg", kSliderFlags);
  ImGui::SetNextItemWidth(kSliderWidthPx);
  ImGui::SliderFloat("turbulence", &wind.turbulence, 0.0f, WindControls::kMostTurbulence, "%.2f",
                     kSliderFlags);
  return wind;
}

float width_px(std::span<const Action* const> buttons) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float sum_px = 0.0f;
  for (const Action* action : buttons)
    sum_px +=
        ImGui::CalcTextSize(action->label.c_str()).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
  return sum_px;
}

/// Side by side; the name of the one that is pressed is chosen.
void buttons_in_row(std::span<const Action* const> buttons, std::vector<std::string>& chosen) {
  for (const Action* action : buttons) {
    if (action != buttons.front()) ImGui::SameLine();
    ImGui::PushID(action->name.c_str());
    if (ImGui::SmallButton(action->label.c_str())) chosen.push_back(action->name);
    ImGui::PopID();
  }
}

void statistics_panel(PanelInput& input) {
  show(statistics_lines(input.session, input.frame));
}

void camera_panel(PanelInput& input) {
  show(camera_line(input.session));
}

void time_panel(PanelInput& input) {
  show(time_line(input.session));
}

void walker_panel(PanelInput& input) {
  show(walker_lines(input.session, input.frame));
}

void quality_panel(PanelInput& input) {
  std::optional<Quality>& quality = input.session.frame_options.quality;
  quality = quality_slider(quality.value());
}

void wind_panel(PanelInput& input) {
  input.session.play.set_wind(wind_sliders(input.session.play.wind()));
}

/// The buttons of a menu stay together, beside those of the last one where the row has room.
void button_panel(PanelInput& input) {
  std::vector<const Action*> all;
  for (const Action& action : input.actions)
    if (action.has_button && action.is_available(input.session)) all.push_back(&action);
  float row_px = 0.0f;
  for (auto first = all.begin(); first != all.end();) {
    const auto end =
        std::find_if(first, all.end(), [&](const Action* other) { return other->menu != (*first)->menu; });
    const std::span<const Action* const> menu(first, end);
    const bool fits = first != all.begin() && row_px + width_px(menu) <= kButtonRowPx;
    if (fits) ImGui::SameLine();
    row_px = (fits ? row_px : 0.0f) + width_px(menu);
    buttons_in_row(menu, input.chosen);
    first = end;
  }
}

void field_panel(PanelInput& input) {
  show(field_line(input.session));
}

/// What the last action told stands in the place of what keys do.
void help_panel(PanelInput& input) {
  const std::string& notice = input.session.notice;
  show(notice.empty() ? short_key_help(input.actions, input.session) : notice);
}

}  // namespace

std::vector<PanelWindow> viewer_panels() {
  return {{"prairie",
           {0.0f, 0.0f},
           {statistics_panel, camera_panel, time_panel, walker_panel, quality_panel, wind_panel, button_panel,
            field_panel, help_panel}}};
}

}  // namespace prairie
