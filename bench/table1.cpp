// Table 1 of B11: a square of 280 m with a million blades, drawn still (A), in wind (B), and in wind with
// things that roll through it and blades that move by themselves around them (C). Frame by frame in turn,
// what moves included.
#include <fmt/format.h>

#include <chrono>
#include <ostream>
#include <vector>

#include "bench/benches.h"
#include "bench/scale_target.h"
#include "bench/timing.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"
#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr int kWarmUp = 90;  // until wakes of blades that swing lie behind all movers
constexpr int kFrames = 120;
constexpr double kStepS = 1.0 / 60.0;
constexpr glm::dvec2 kEyeM{140.0, 100.0};

constexpr const char* kField = R"(version = 1
[ground]
size_m = [280, 280]
[[species]]
name = "grass"
density = 12.7551
height_m = 0.9
width_mm = 8
[lod]
blade_distance_m = 280
)";
constexpr const char* kWind = R"([wind]
speed_m_per_s = 4
heading_deg = 60
)";

// Seven stones that roll round before the eye, all within the reach of interaction patches.
std::string movers() {
  std::string text;
  for (int n = 0; n < 7; ++n) {
    const double x = kEyeM.x - 13.0 + 6.5 * (n % 4), y = kEyeM.y + 13.0 + 6.0 * (n / 4);
    text += fmt::format(
        "[[mover]]\nname = \"stone {}\"\nkind = \"stone\"\nradius_m = 2\nspeed_m_per_s = 8.3\nloops = true\n"
        "path_m = [[{}, {}], [{}, {}], [{}, {}], [{}, {}]]\n",
        static_cast<char>('a' + n), x, y, x + 7, y + 1, x + 6, y + 9, x - 1, y + 8);
  }
  return text;
}

class Column {
 public:
  Column(const std::string& text, const BenchOptions& options)
      : world_(parse_scene(text, ".", {}), {}), renderer_(world_, options.shader_folder) {
    camera_.eye_m = {kEyeM.x, kEyeM.y, 1.7};
    camera_.pitch_rad = -0.12;
    world_.watch_anew(kEyeM);
  }

  void step(int frame, const OffscreenTarget& target) {
    const auto start = std::chrono::steady_clock::now();
    double step_ms = 0.0;
    stages_ = renderer_
                  .draw({camera_, {}, target.framebuffer()},
                        [&] { step_ms = elapsed_ms([&] { world_.step(kStepS); }); })
                  .gpu_times;
    glFinish();
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    if (frame < 0) return;
    ms_.push_back(passed.count());
    step_ms_.push_back(step_ms);
    touched_.push_back(static_cast<double>(world_.motion().touched().size()));
  }

  /// What of a frame goes where.
  void tell(const char* name, std::ostream& out) const {
    out << fmt::format("table1 {}: step {:.2f} ms", name, median(step_ms_));
    for (const StageTime& stage : stages_) out << fmt::format(", {} {:.1f} ms", stage.name, stage.ms);
    out << '\n';
  }

  double ms() const { return median(ms_); }
  /// The median of frames drawn one after the other: a machine that others use is fast and slow by turns.
  double ms_per(const Column& other) const {
    std::vector<double> ratios;
    for (std::size_t n = 0; n < ms_.size(); ++n) ratios.push_back(ms_[n] / other.ms_[n]);
    return median(ratios);
  }
  double touched() const { return median(touched_); }

 private:
  World world_;
  Renderer renderer_;
  Camera camera_;
  std::vector<StageTime> stages_;
  std::vector<double> ms_, step_ms_, touched_;
};

}  // namespace

std::vector<Measurement> bench_table1(const BenchOptions& options) {
  const HeadlessContext context(options.device);
  const OffscreenTarget target({800, 600});
  const std::string field = kField, windy = field + kWind;
  Column a(field, options), b(windy, options), c(windy + movers(), options);
  for (int frame = -kWarmUp; frame < kFrames; ++frame) {
    for (Column* column : {&a, &b, &c}) column->step(frame, target);
  }
  if (options.details != nullptr) {
    a.tell("A", *options.details);
    b.tell("B", *options.details);
    c.tell("C", *options.details);
  }
  return {{"table1.a_ms", a.ms()},
          {"table1.b_ms", b.ms()},
          {"table1.c_ms", c.ms()},
          {"table1.c_per_a", c.ms_per(a)},
          {"table1.inertial_blades", c.touched()}};
}

}  // namespace prairie
