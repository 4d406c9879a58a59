#include "render/frame/renderer.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <future>
#include <glm/gtc/type_precision.hpp>
#include <optional>

#include "lod/planner.h"
#include "render/gl/gpu_timer.h"
#include "render/gl/graphics_reset.h"
#include "render/gl/render_target.h"
#include "render/gl/shader_program.h"
#include "render/gl/stream_buffer.h"
#include "render/grass/blade_pass.h"
#include "render/grass/ground_pass.h"
#include "render/grass/moving_fields.h"
#include "render/grass/strip_painter.h"
#include "render/grass/strip_pass.h"
#include "render/grass/sward_tables.h"
#include "render/light/light.h"
#include "render/light/noise_texture.h"
#include "render/light/sky_pass.h"
#include "render/overlays/field_overlay_pass.h"
#include "render/overlays/line_pass.h"
#include "render/things/drawn_walkers.h"
#include "render/things/mover_look.h"
#include "render/things/obstacle_pass.h"
#include "render/things/solid_pass.h"
#include "render/things/walker_pass.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// Radical inverses: the sub-pixel shifts of supersampling, evenly spread for any number of samples.
double radical_inverse(int index, int base) {
  double result = 0.0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base) result += digit * (index % base);
  return result;
}

glm::vec2 jitter_of(int sample, int samples, glm::ivec2 size_px) {
  if (samples == 1) return glm::vec2(0.0f);
  const glm::dvec2 shift((sample + 0.5) / samples - 0.5, radical_inverse(sample, 2) + 0.5 / samples - 0.5);
  return glm::vec2(2.0 * shift / glm::dvec2(size_px));
}

struct StageTimers {
  GpuTimer blades, strips, solids, ground, sky;

  std::vector<StageTime> finish_frame() {
    for (GpuTimer* timer : {&blades, &strips, &solids, &ground, &sky}) timer->finish_frame();
    return {{"blades", blades.last_ms()},
            {"strips", strips.last_ms()},
            {"solids", solids.last_ms()},
            {"ground", ground.last_ms()},
            {"sky", sky.last_ms()}};
  }
};

}  // namespace

struct Renderer::Passes {
  Passes(const World& the_world, const std::filesystem::path& shader_folder)
      : world(&the_world),
        planner(the_world.meadow()),
        sward(the_world.meadow()),
        blades(the_world, shader_folder),
        strips(shader_folder),
        solids(shader_folder),
        obstacles(shader_folder),
        walkers(shader_folder),
        sky(shader_folder),
        field_overlay(shader_folder),
        lines(shader_folder),
        tone_program(make_program(shader_folder, {"pass/screen.vert", "pass/tone.frag"})),
        no_vertices(make_vertex_array()) {
    frame = frame_params(the_world, FramePlan{}, GroundLook{}, FieldLook{});
    show_frame();
    glBindTextureUnit(7, noise_texture.get());
    sky.set_light();
    sward.set_light(frame);
    ground.emplace(the_world, shader_folder, sward.blade_area_from_above_m2());
    sward.bind();
    strip_texture =
        StripPainter(the_world, shader_folder)
            .paint(stream, blades, frame_params(the_world, FramePlan{}, GroundLook{}, sward.field()),
                   sward.species(), strip_traits);
    obstacles.set(the_world.standing(), the_world.meadow().ground);
  }

  FramePlan plan(const Camera& camera, const FrameOptions& options, FrameStatistics& statistics) {
    const auto start = std::chrono::steady_clock::now();
    const LodSpec& lod = world->scene().lod;
    FramePlan plan =
        planner.plan(camera, {options.tier, options.quality.value_or(lod.quality), lod.blade_distance_m,
                              options.memory_budget_bytes, options.lod_eye_m});
    statistics.plan_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    statistics.blades_planted_in_view = plan.blades_planted_in_view;
    statistics.blades_drawn = plan.blades_drawn;
    return plan;
  }

  const RenderTarget& target_of(const Camera& camera, bool msaa) {
    if (!target || target->size_px() != camera.size_px || target->msaa() != msaa)
      target.emplace(camera.size_px, msaa);
    return *target;
  }

  // Uploads the plan and has blades and strips grown.
  void prepare(const FramePlan& plan, const FrameOptions& options, FrameStatistics& statistics) {
    stream.begin_frame();
    const GroundLook look = ground->look(plan.camera.eye_m);
    frame = frame_params(*world, plan, look, sward.field());
    frame.tint = options.tier_tint ? 1.0f : 0.0f;
    exposure = frame.exposure;
    variant = grass_variant(world->motion());
    fields.show(world->motion(), glm::dvec2(plan.camera.eye_m), frame);
    show_frame();
    sward.bind();
    fields.bind();
    blades.prepare(stream, plan, sward.species(), variant, &world->motion().touched());
    timers.strips.begin();
    strips.prepare(stream, plan, sward.species(), strip_traits, variant);
    timers.strips.end();
    solids.prepare(stream, drawn_movers(*world), plan.camera);
    std::vector<WalkerLook> looks = drawn_walkers(*world, plan.camera);
    looks.insert(looks.end(), options.walkers.begin(), options.walkers.end());
    obstacles.prepare(plan.camera);
    walkers.prepare(stream, looks, plan.camera, frame.strip_height_m);
    field_overlay.prepare(stream, *world, plan.camera.eye_m, options.field_overlay);
    lines.prepare(stream, options.lines, plan.camera);
    statistics.spline.triangles = blades.spline_triangles();
    statistics.hermite.triangles = blades.hermite_triangles();
    statistics.strip = {plan.blades_in_strips, strips.triangles()};
    for (const CellGroup& group : plan.groups) {
      std::uint64_t& sum = group.is_spline ? statistics.spline.blades : statistics.hermite.blades;
      for (std::uint32_t n = 0; n < group.cell_count; ++n) sum += plan.cells[group.first_cell + n].drawn;
    }
  }

  void show_frame() {
    const StreamBuffer::Slice slice = stream.write(&frame, sizeof(frame));
    glBindBufferRange(GL_UNIFORM_BUFFER, 0, slice.buffer, slice.offset, sizeof(frame));
  }

  // Begins what is done meanwhile, which ends with `get`.
  std::future<void> begin_meanwhile(const Meanwhile& meanwhile, glm::dvec2 eye_m) {
    if (!meanwhile) return std::async(std::launch::deferred, [] {});
    const bool has_threads =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
    return std::async(has_threads ? std::launch::async : std::launch::deferred, [this, &meanwhile, eye_m] {
      meanwhile();
      // Most likely that is what the next frame shows.
      fields.paint(world->motion(), eye_m);
    });
  }

  // Reads nothing that time moves: the world may be stepped meanwhile.
  void draw(const FramePlan& plan, glm::vec2 jitter, FrameStatistics& statistics) {
    frame.jitter = jitter;
    show_frame();
    sward.bind();
    fields.bind();
    glBindTextureUnit(7, noise_texture.get());
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    // Blades first: they hide most of the ground, whose fragments cost more.
    timers.blades.begin();
    blades.draw(stream);
    timers.blades.end();
    timers.strips.begin();
    strips.draw(strip_texture.get());
    timers.strips.end();
    timers.solids.begin();
    obstacles.draw();
    solids.draw();
    walkers.draw();
    timers.solids.end();
    timers.ground.begin();
    ground->draw(plan, ground->anchor_m(plan.camera.eye_m), variant);
    timers.ground.end();
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    timers.sky.begin();
    sky.draw(plan.camera);
    timers.sky.end();
    field_overlay.draw();
    lines.draw();
    glDepthMask(GL_TRUE);
    statistics.flat.triangles = ground->triangles_drawn();
    statistics.triangles = statistics.spline.triangles + statistics.hermite.triangles +
                           statistics.strip.triangles + statistics.flat.triangles +
                           obstacles.triangles_drawn() + solids.triangles_drawn() + walkers.triangles_drawn();
  }

  void tone_map(GLuint linear_texture, GLuint framebuffer, glm::ivec2 size_px) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size_px.x, size_px.y);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(tone_program.get());
    glProgramUniform1f(tone_program.get(), 0, exposure);
    glBindTextureUnit(0, linear_texture);
    glBindVertexArray(no_vertices.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  const World* world;
  Planner planner;
  StageTimers timers;
  StreamBuffer stream{std::size_t{1} << 20};
  SwardTables sward;
  BladePass blades;
  StripPass strips;
  SolidPass solids;
  ObstaclePass obstacles;
  WalkerPass walkers;
  std::optional<GroundPass> ground;
  GlTexture strip_texture;
  std::vector<StripTraits> strip_traits;  // by species
  MovingFields fields;
  GrassVariant variant;
  GlTexture noise_texture = make_noise_texture();
  SkyPass sky;
  FieldOverlayPass field_overlay;
  LinePass lines;
  GlProgram tone_program;
  GlVertexArray no_vertices;
  FrameParams frame{};
  std::optional<RenderTarget> target;
  float exposure = 1.0f;
};

Renderer::Renderer(const World& world, const std::filesystem::path& shader_folder)
    : passes_(std::make_unique<Passes>(world, shader_folder)) {}

Renderer::~Renderer() = default;

void Renderer::stand(const StandingThings& things) {
  passes_->obstacles.set(things, passes_->world->meadow().ground);
}

FrameStatistics Renderer::draw(const Camera& camera, const FrameOptions& options, unsigned target,
                               const Meanwhile& meanwhile) {
  FrameStatistics statistics;
  const FramePlan plan = passes_->plan(camera, options, statistics);
  const RenderTarget& frame = passes_->target_of(camera, options.msaa);
  passes_->prepare(plan, options, statistics);
  std::future<void> beside = passes_->begin_meanwhile(meanwhile, glm::dvec2(camera.eye_m));
  frame.begin();
  passes_->draw(plan, glm::vec2(0.0f), statistics);
  passes_->tone_map(frame.resolved(), target, camera.size_px);
  glFlush();
  beside.get();
  statistics.gpu_times = passes_->timers.finish_frame();
  check_context();
  return statistics;
}

Picture Renderer::render(const Camera& camera, const FrameOptions& options, int samples,
                         const Meanwhile& meanwhile) {
  assert(samples >= 1);
  Picture picture;
  picture.width = camera.size_px.x;
  picture.height = camera.size_px.y;
  passes_->planner.forget();  // a picture depends on nothing that was drawn before
  const FramePlan plan = passes_->plan(camera, options, picture.statistics);
  const RenderTarget& frame = passes_->target_of(camera, options.msaa);
  const std::size_t values = std::size_t{4} * picture.width * picture.height;
  std::vector<double> sum(values, 0.0);
  std::vector<float> pixels(values);
  passes_->prepare(plan, options, picture.statistics);
  std::future<void> beside = passes_->begin_meanwhile(meanwhile, glm::dvec2(camera.eye_m));
  for (int sample = 0; sample < samples; ++sample) {
    frame.begin();
    passes_->draw(plan, jitter_of(sample, samples, camera.size_px), picture.statistics);
    passes_->timers.finish_frame();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.resolved_framebuffer());
    glReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_FLOAT, pixels.data());
    for (std::size_t n = 0; n < values; ++n) sum[n] += static_cast<double>(pixels[n]);
  }
  check_context();
  const std::size_t pixel_count = values / 4;
  picture.linear_rgb.resize(3 * pixel_count);
  picture.srgb.resize(3 * pixel_count);
  picture.cover.resize(pixel_count);
  Kernels kernels;
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    // OpenGL's rows come from the bottom.
    const std::size_t row = pixel / static_cast<std::size_t>(picture.width);
    const std::size_t to = pixel + (static_cast<std::size_t>(picture.height) - 1 - 2 * row) * picture.width;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto value = static_cast<float>(sum[4 * pixel + channel] / samples);
      const float encoded = kernels.srgb_from_linear(kernels.tone_curve(passes_->exposure * value));
      picture.linear_rgb[3 * to + channel] = value;
      picture.srgb[3 * to + channel] =
          static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(encoded, 0.0f, 1.0f)));
    }
    picture.cover[to] = static_cast<float>(sum[4 * pixel + 3] / samples);
  }
  beside.get();
  return picture;
}

}  // namespace prairie
