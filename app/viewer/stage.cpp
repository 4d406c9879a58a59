#include "app/viewer/stage.h"

#include "app/scenes/installed_files.h"

namespace prairie {
namespace {

constexpr int kPictureSamples = 4;
constexpr unsigned kWindowTarget = 0;

}  // namespace

Stage::Stage(const World& world, glm::ivec2 size_px)
    : window_(size_px), renderer_(world, shader_folder()), panels_(window_.handle()) {}

FrameStatistics Stage::draw(const Camera& camera, const FrameOptions& options,
                            const std::function<void()>& meanwhile) {
  return renderer_.draw({camera, options, kWindowTarget}, meanwhile);
}

void Stage::draw_panels(const std::vector<PanelWindow>& windows, PanelInput& input) {
  panels_.draw(windows, input);
}

Picture Stage::picture(const Camera& camera, const FrameOptions& options) {
  return renderer_.render(camera, options, kPictureSamples);
}

}  // namespace prairie
