#include "tests/bench/window/mesh_frames.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/drawn_mesh.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/view/section_cap.h"
#include "app/gui/window/main_window.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"

namespace underact::gui {
namespace {

constexpr int kMeshPhase_ms = 5'000;
constexpr std::size_t kWhole = std::numeric_limits<std::size_t>::max();

struct Row {
  const char* scene;
  const char* mesh;  // beside the scenes
};

/// The scene with another mesh, with a surface of its own: nothing of it was drawn before.
scene::Description sceneOf(const std::string& source, const Row& row) {
  scene::Description scene = scene::readSceneFile(source + "/scenes/" + row.scene + ".json").value();
  auto& mesh = std::get<scene::Mesh>(scene.constraints[0].shape);
  mesh.file = row.mesh;
  const Problems problems = scene::loadMeshes(scene);
  if (!problems.empty()) {
    std::fprintf(stderr, "%s\n", problems.front().sentence.c_str());
    return {};
  }
  mesh.surface = std::make_shared<const mesh::Surface>(*mesh.surface);
  return scene;
}

double share(std::vector<double> sorted, double of_all) {
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(of_all * static_cast<double>(sorted.size() - 1))];
}

void measureFrames(SimulatedHost& simulated, MainWindow& window, const char* what) {
  std::vector<double> frames_ms;
  const auto counting = QObject::connect(&window.view(), &SceneView::drawn, &window,
                                         [&](double frame_ms) { frames_ms.push_back(frame_ms); });
  QElapsedTimer clock;
  clock.start();
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &timer, [&] {  // round and through the mesh, once in 2 s
    const double angle_rad = 3.14e-9 * static_cast<double>(clock.nsecsElapsed());
    sim::HandSetpoint setpoint;
    setpoint.p_WT = {0.035 * std::cos(angle_rad), 0.02 * std::sin(2 * angle_rad), 0.02 * std::sin(angle_rad)};
    simulated.arm->setSetpoint(setpoint);
  });
  timer.start(8);
  QEventLoop loop;  // quit() of the program would close the window
  QTimer::singleShot(kMeshPhase_ms, &loop, &QEventLoop::quit);
  loop.exec();
  QObject::disconnect(counting);
  std::sort(frames_ms.begin(), frames_ms.end());
  std::printf("  %-10s %5.1f frames/s, a frame p50 %6.1f  p99 %6.1f  max %6.1f ms\n", what,
              1e3 * static_cast<double>(frames_ms.size()) / kMeshPhase_ms, share(frames_ms, 0.5),
              share(frames_ms, 0.99), share(frames_ms, 1.0));
  std::fflush(stdout);
}

/// The cut alone, of what is drawn, across the middle and all along.
double cut_ms(const mesh::Triangles& triangles, double scale) {
  constexpr int kCuts = 60;
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.block<3, 3>(0, 0) *= scale;
  SectionCap cap;
  QElapsedTimer clock;
  clock.start();
  for (int cut = 0; cut < kCuts; ++cut) {
    cap.clear();
    cap.add(triangles, X, cut % 3, 0.5 * (cut - kCuts / 2), true);
    cap.done();
  }
  return 1e-6 * static_cast<double>(clock.nsecsElapsed()) / kCuts;
}

void measureOne(const std::string& source, const Row& row, std::size_t max) {
  scene::Description scene = sceneOf(source, row);
  if (scene.constraints.empty()) return;
  const auto surface = std::get<scene::Mesh>(scene.constraints[0].shape).surface;
  QElapsedTimer clock;
  clock.start();
  const auto drawn = drawnMesh(surface, {}, max);
  std::printf("%s: %zu triangles, %zu drawn, made in %lld ms", row.mesh, surface->triangles.faces.size(),
              drawn->triangles, static_cast<long long>(clock.elapsed()));
  std::printf(", cut in %.2f ms\n", cut_ms(drawn->is_coarser ? drawn->coarser : surface->triangles,
                                           std::get<scene::Mesh>(scene.constraints[0].shape).scale_mm_per_unit));
  SimulatedHost simulated = makeSimulatedHost({});
  ThemeWatcher theme;
  MainWindow window({*simulated.host, simulated.arm, theme});
  window.resize(1280, 800);
  window.show();
  static_cast<void>(window.document().open(std::move(scene)));
  window.actions().perform("session.start");
  window.actions().perform("layer.section", false);
  measureFrames(simulated, window, "plain");
  window.actions().perform("layer.section_follows", true);
  window.actions().perform("section.z", true);
  window.actions().perform("layer.section", true);
  measureFrames(simulated, window, "cut");
  window.document().undoStack().setClean();
}

}  // namespace

void measureMeshFrames(const std::string& source) {
  const Row rows[] = {{"25_torus_knot", "meshes/torus_knot_300k.stl"},
                      {"26_bumpy_sphere", "meshes/bumpy_sphere_300k.ply"},
                      {"27_bracket", "meshes/bracket_300k.obj"}};
  measureOne(source, {"25_torus_knot", "meshes/torus_knot_20k.stl"}, kMaxDrawn);
  for (const Row& row : rows) {
    for (const std::size_t max : {kMaxDrawn, kWhole}) measureOne(source, row, max);
  }
}

}  // namespace underact::gui
