#include "render/frame/renderer.h"

#include <tbb/global_control.h>

#include <cassert>
#include <chrono>
#include <deque>
#include <future>
#include <optional>

#include "lod/planner.h"
#include "render/frame/frame_blocks.h"
#include "render/frame/scene_passes.h"
#include "render/gl/gpu_timeline.h"
#include "render/gl/graphics_reset.h"
#include "render/gl/render_target.h"
#include "render/gl/stream_buffer.h"
#include "render/gl/uniform_block.h"
#include "render/post/develop.h"
#include "render/post/developed_picture.h"
#include "render/post/supersampling.h"
#include "world/motion.h"

namespace prairie {
namespace {

/// What belongs to a view from frame to frame.
struct ViewState {
  explicit ViewState(const Meadow& meadow) : planner(meadow) {}

  const RenderTarget& target_for(const Camera& camera, bool msaa) {
    if (!target || target->size_px() != camera.size_px || target->msaa() != msaa)
      target.emplace(camera.size_px, msaa);
    return *target;
  }

  Planner planner;
  std::optional<RenderTarget> target;
};

void add_blades(const FramePlan& plan, FrameStatistics& statistics) {
  statistics.blades_planted_in_view = plan.blades_planted_in_view;
  statistics.blades_drawn = plan.blades_drawn;
  statistics.strip.blades = plan.blades_in_strips;
  for (const CellGroup& group : plan.groups) {
    std::uint64_t& sum = group.is_spline ? statistics.spline.blades : statistics.hermite.blades;
    for (std::uint32_t n = 0; n < group.cell_count; ++n) sum += plan.cells[group.first_cell + n].drawn;
  }
}

}  // namespace

struct Renderer::Parts {
  Parts(const World& the_world, const std::filesystem::path& shader_folder)
      : world(&the_world),
        scene(the_world, shader_folder, stream),
        passes(passes_of(scene)),
        develop(shader_folder),
        picture_view(the_world.meadow()) {}

  FramePlan plan(ViewState& view, const Camera& camera, const FrameOptions& options,
                 FrameStatistics& statistics) const {
    const auto start = std::chrono::steady_clock::now();
    const LodSpec& lod = world->scene().lod;
    Camera seen = camera;
    seen.near_m =
        near_plane_m(camera.eye_m.z - static_cast<double>(world->meadow().ground.height_m(camera.eye_m)));
    FramePlan plan =
        view.planner.plan(seen, {options.tier, options.quality.value_or(lod.quality), lod.blade_distance_m,
                                 options.memory_budget_bytes, options.lod_eye_m});
    statistics.plan_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    add_blades(plan, statistics);
    return plan;
  }

  // Uploads what the view shows and has blades and strips grown.
  void prepare(const ViewInputs& in) {
    blocks = {view_params(in.plan, world->meadow()), scene.light, scene.field};
    blocks.view.tint = in.options.tier_tint ? 1.0f : 0.0f;
    scene.moving_fields.show(world->motion(), glm::dvec2(in.plan.camera.eye_m), blocks.view, blocks.field);
    bind(stream, blocks);
    scene.bind_shared();
    is_shown.assign(passes.size(), false);
    timeline.begin();
    for (std::size_t n = 0; n < passes.size(); ++n) is_shown[n] = passes[n].prepare(in);
    timeline.end(passes.size());
  }

  // Reads nothing that time moves: the world may be stepped meanwhile.
  void draw(const ViewInputs& in, glm::vec2 jitter) {
    blocks.view.jitter = jitter;
    bind_uniform_block(stream, layouts::kViewBlock, blocks.view);
    scene.bind_shared();
    timeline.begin();
    for (std::size_t n = 0; n < passes.size(); ++n) {
      if (!is_shown[n]) continue;
      set_draw_state(passes[n].state);
      passes[n].draw(in);
      timeline.end(n);
    }
  }

  // Begins what is done meanwhile, which ends with `get`.
  std::future<void> begin_meanwhile(const Meanwhile& meanwhile, glm::dvec2 eye_m) {
    if (!meanwhile) return std::async(std::launch::deferred, [] {});
    const bool has_threads =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
    return std::async(has_threads ? std::launch::async : std::launch::deferred, [this, &meanwhile, eye_m] {
      meanwhile();
      // Most likely that is what the next frame shows.
      scene.moving_fields.paint(world->motion(), eye_m);
    });
  }

  void add_triangles(FrameStatistics& statistics) const {
    for (std::size_t n = 0; n < passes.size(); ++n)
      if (is_shown[n]) statistics.triangles += passes[n].triangles();
    statistics.spline.triangles = scene.blades.spline_triangles();
    statistics.hermite.triangles = scene.blades.hermite_triangles();
    statistics.strip.triangles = scene.strips.triangles();
    statistics.flat.triangles = scene.ground.triangles_drawn();
  }

  // Of what took time in the latest frame that is known.
  std::vector<StageTime> finish_timeline() {
    timeline.finish_frame();
    std::vector<StageTime> times;
    const std::vector<double>& last_ms = timeline.last_ms();
    for (std::size_t n = 0; n < last_ms.size(); ++n) {
      if (last_ms[n] > 0.0) times.push_back({n < passes.size() ? passes[n].name : "prepare", last_ms[n]});
    }
    return times;
  }

  ViewInputs inputs(const FramePlan& plan, const FrameOptions& options) {
    return {*world, plan, options, grass_variant(world->motion()), scene.field.strip_height_m, stream};
  }

  const World* world;
  StreamBuffer stream{std::size_t{1} << 20};
  ScenePasses scene;
  std::vector<Pass> passes;
  GpuTimeline timeline;        // stages are passes, and one more that prepares them
  std::vector<bool> is_shown;  // by pass: whether it has something to draw in the view that was prepared
  Develop develop;
  FrameBlocks blocks;           // of that view
  std::deque<ViewState> views;  // by their place in the frame
  ViewState picture_view;
  FrameStatistics picture_statistics;
};

Renderer::Renderer(const World& world, const std::filesystem::path& shader_folder)
    : parts_(std::make_unique<Parts>(world, shader_folder)) {}

Renderer::~Renderer() = default;

std::vector<Pass>& Renderer::passes() {
  return parts_->passes;
}

std::vector<FrameStatistics> Renderer::draw(std::span<const FrameView> views, const Meanwhile& meanwhile) {
  assert(!views.empty());
  while (parts_->views.size() < views.size()) parts_->views.emplace_back(parts_->world->meadow());
  std::vector<FrameStatistics> statistics(views.size());
  std::future<void> beside;
  parts_->stream.begin_frame();
  for (std::size_t n = 0; n < views.size(); ++n) {
    const FrameView& view = views[n];
    ViewState& state = parts_->views[n];
    const FramePlan plan = parts_->plan(state, view.camera, view.options, statistics[n]);
    const RenderTarget& frame = state.target_for(view.camera, view.options.msaa);
    const ViewInputs in = parts_->inputs(plan, view.options);
    parts_->prepare(in);
    if (n + 1 == views.size()) beside = parts_->begin_meanwhile(meanwhile, glm::dvec2(view.camera.eye_m));
    frame.begin();
    parts_->draw(in, glm::vec2(0.0f));
    parts_->add_triangles(statistics[n]);
    parts_->develop.draw(frame.resolved(), view.target, view.camera.size_px, parts_->scene.light.exposure);
  }
  glFlush();
  beside.get();
  const std::vector<StageTime> gpu_times = parts_->finish_timeline();
  for (FrameStatistics& one : statistics) one.gpu_times = gpu_times;
  check_context();
  return statistics;
}

FrameStatistics Renderer::draw(const FrameView& view, const Meanwhile& meanwhile) {
  return draw(std::span(&view, 1), meanwhile).front();
}

Picture Renderer::render(const Camera& camera, const FrameOptions& options, int samples,
                         const Meanwhile& meanwhile) {
  assert(samples >= 1);
  ViewState& state = parts_->picture_view;
  state.planner.forget();
  FrameStatistics statistics;
  const FramePlan plan = parts_->plan(state, camera, options, statistics);
  const RenderTarget& frame = state.target_for(camera, options.msaa);
  SampleSum sum(camera.size_px);
  const ViewInputs in = parts_->inputs(plan, options);
  parts_->stream.begin_frame();
  parts_->prepare(in);
  std::future<void> beside = parts_->begin_meanwhile(meanwhile, glm::dvec2(camera.eye_m));
  for (int sample = 0; sample < samples; ++sample) {
    frame.begin();
    parts_->draw(in, sample_shift(sample, samples, camera.size_px));
    statistics.gpu_times = parts_->finish_timeline();
    sum.add(frame.resolved_framebuffer());
  }
  check_context();
  parts_->add_triangles(statistics);
  parts_->picture_statistics = std::move(statistics);
  Picture picture = developed_picture(camera.size_px, sum.mean(), parts_->scene.light.exposure);
  beside.get();
  return picture;
}

const FrameStatistics& Renderer::picture_statistics() const {
  return parts_->picture_statistics;
}

}  // namespace prairie
