#include <array>
#include <map>
#include <string>

#include "core/scene/compile.h"
#include "core/scene/read.h"
#include "tests/error_bounds/malformed_tick.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace ticks_rows {

/// One scene for each kind of state that a tick has. The shipped ones are covered by the tests.
constexpr std::array<const char*, 9> kConstraints{
    R"("control": {"law": "P", "kp_N_per_mm": 0.5}, "constraints": [{"name": "a", "type": "point", "position_mm": [10, 20, 30]}])",
    R"("control": {"law": "PD", "kp_N_per_mm": 0.5, "kd_N_s_per_mm": 0.002, "velocity": {"filter": "adaptive_window"}},
       "constraints": [{"name": "a", "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 40, "friction": {"static": 0.4}}])",
    R"("control": {"law": "PID", "kp_N_per_mm": 0.3, "kd_N_s_per_mm": 0.002, "ki_N_per_mm_s": 0.5, "velocity": {"filter": "kalman"}},
       "constraints": [{"name": "a", "type": "line", "point_mm": [0, 30, 0], "direction": [-1, -2, 1]}])",
    R"("control": {"law": "PID", "kp_N_per_mm": [1000, 0.2, 0.4], "kd_N_s_per_mm": 0.002, "ki_N_per_mm_s": 0.5, "velocity": {"filter": "low_pass"}},
       "constraints": [{"name": "a", "type": "cylinder", "point_mm": [0, 0, 0], "axis": [1, 1, 1], "radius_mm": 30}])",
    R"("control": {"law": "PD", "kp_N_per_mm": 12, "kd_N_s_per_mm": 0.002, "velocity": {"filter": "raw"}, "passivity": "control"}, "combine": "nearest",
       "constraints": [{"name": "a", "type": "box", "center_mm": [0, 0, 0], "size_mm": [60, 50, 40], "side": "inside"},
                       {"name": "b", "type": "plane", "point_mm": [0, 0, 0], "normal": [0, 1, 0], "side": "outside"}])",
    R"("control": {"law": "P", "kp_N_per_mm": 0.5},
       "constraints": [{"name": "a", "type": "circle", "center_mm": [0, 0, 0], "normal": [0, 0, 1], "radius_mm": 50, "influence": {"t": 0.5}},
                       {"name": "b", "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 50, "influence": {"t": 0.3}}])",
    R"("control": {"law": "PD", "kp_N_per_mm": 0.1, "kd_N_s_per_mm": 0.0002, "space": "joint"},
       "constraints": [{"name": "a", "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 50}])",
    R"("control": {"law": "P", "kp_N_per_mm": 0.5},
       "constraints": [{"name": "a", "type": "virtual_manipulator", "joints": [{"type": "revolute", "axis": [0, 0, 1], "point_mm": [0, 0, 0]}],
         "X_WV_home": [[0, 0, 1, 50], [0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]], "orientation": "angle", "ko_N_mm_per_rad": 250}])",
    R"("control": {"law": "P", "kp_N_per_mm": 0.5},
       "constraints": [{"name": "a", "type": "virtual_manipulator", "joints": [{"type": "revolute", "axis": [0, 0, 1], "point_mm": [0, 0, 0]},
         {"type": "revolute", "axis": [0, 1, 0], "point_mm": [30, 0, 0]}, {"type": "prismatic", "axis": [1, 0, 0]}],
         "X_WV_home": [[0, 0, 1, 50], [0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]], "orientation": "full", "ko_N_mm_per_rad": 250}])"};

const std::vector<tick::TickProgram>& programs() {
  static const std::vector<tick::TickProgram> kPrograms = [] {
    std::vector<tick::TickProgram> all;
    for (const char* constraint : kConstraints) {
      const std::string text = R"({"underact_scene": 1, "title": "Strange ticks", )" + std::string(constraint) + "}";
      const Result<scene::Description> scene = scene::readScene(text, "extremes");
      if (!scene) continue;
      Result<tick::TickProgram> program = scene::compile(scene.value());
      if (program) all.push_back(std::move(program).value());
    }
    return all;
  }();
  return kPrograms;
}

Outcome judge(Input& input) {
  const std::vector<tick::TickProgram>& all = programs();
  if (all.size() != kConstraints.size()) return {kInfinity, false};
  return checkMalformedTick(all[input.choice("scene", all.size())], input);
}

constexpr std::array<Row, 1> kRows{{
    {"tick_strange", Kind::Tick,
     "Tick: NaN, infinities, denormals, 1e308 and any time in every field of its input, then Start",
     "ulp of the greatest force beyond it; finite and zero where refused; after the Start the bits of a new one", 4, 1,
     judge},
}};

}  // namespace ticks_rows

constinit const std::span<const Row> kTickRows = ticks_rows::kRows;

}  // namespace underact::error_bounds
