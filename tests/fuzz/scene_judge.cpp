#include "tests/fuzz/scene_judge.h"

#include <algorithm>
#include <memory>

#include "core/json/text.h"
#include "core/scene/compile.h"
#include "core/scene/write.h"
#include "core/tick/step.h"
#include "tests/core/scene/scene_support.h"

namespace underact::test {
namespace {

bool isUtf8(std::string_view text) {
  for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
    length = json::codePointLength(text, at);
    if (length == 0) return false;
  }
  return true;
}

std::string judgeProblems(const Problems& problems, std::string_view text) {
  if (problems.empty()) return "Refused without a problem.";
  const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
  for (const Problem& problem : problems) {
    const SourceLocation& place = problem.place;
    const std::string given = describe(problem);
    if (place.line < 1 || place.line > lines || place.column < 1) return "No place of the file: " + given;
    if (problem.sentence.size() < 10 || std::string_view(".?").find(problem.sentence.back()) == std::string_view::npos)
      return "No sentence: " + given;
    if (problem.sentence.pattern().empty()) return "No other language can say: " + given;
    if (!isUtf8(given) || given.size() > 1000 || given.find('\n') != std::string::npos) return "Not one line: " + given;
  }
  return {};
}

std::string judgeTick(const tick::TickProgram& program) {
  tick::TickState state = makeState(program);
  const auto report = std::make_unique<tick::TickReport>();
  for (int i = 1; i <= 3; ++i) {
    tick::TickInput input;
    input.sample.time_ns = i * 400'000'000LL;
    input.sample.q_rad = {0.1 * i, 0.3, 0.2, 0.0, 1.5, 0.0};
    input.engage = true;
    step(program, input, state, *report);
    const Vec3& f_T_W = report->force.f_T_W();
    if (!f_T_W.allFinite() || f_T_W.norm() > program.limits.max_force_N * (1.0 + 1e-12))
      return "The gate let it through.";
  }
  return {};
}

/// Files that no mutation wrote: a tetrahedron in the place of each mesh, three points in that of each curve. False: a
/// scale or a pose takes them where no curve may be, which only compile() can say.
bool fill(scene::Description& scene) {
  static const std::shared_ptr<const mesh::Surface> tetrahedron = [] {
    mesh::Triangles triangles;
    triangles.p_MV = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
    triangles.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh::makeSurface(std::move(triangles)).value();
  }();
  static const auto points =
      std::make_shared<const std::vector<Vec3>>(std::vector<Vec3>{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}});
  bool all = true;
  for (scene::Constraint& constraint : scene.constraints) {
    if (auto* const mesh = std::get_if<scene::Mesh>(&constraint.shape)) mesh->surface = tetrahedron;
    if (auto* const curve = std::get_if<scene::Curve>(&constraint.shape)) {
      curve->points = points;
      all = all && static_cast<bool>(scene::makeCurvePath(*curve));
    }
  }
  return all;
}

std::string judgeDescription(scene::Description scene) {
  if (!scene::check(scene).empty()) return "Read, but check() objects.";
  if (!fill(scene)) return {};
  const Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return "Read, but does not compile: " + joined(linesOf(program.problems()));
  if (program.value().entries.size() != scene.constraints.size()) return "Half loaded.";
  const std::string written = scene::writeScene(scene);
  const Result<scene::Description> again = scene::readScene(written, "again");
  if (!again) return "What was written is refused: " + joined(linesOf(again.problems())) + written;
  if (!same(again.value(), scene)) return "Reads back to another scene: " + written;
  return judgeTick(program.value());
}

}  // namespace

std::string judgeScene(std::string_view text) {
  const Result<scene::Description> read = scene::readScene(text, "fuzz.json");
  return read ? judgeDescription(read.value()) : judgeProblems(read.problems(), text);
}

bool isAccepted(std::string_view text) {
  return static_cast<bool>(scene::readScene(text, "fuzz.json"));
}

}  // namespace underact::test
