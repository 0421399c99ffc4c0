#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string_view>

#include "app/gui/kit/actions.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/gl_surface.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/window/main_window.h"
#include "core/record/recorder.h"
#include "core/scene/read.h"
#include "tests/bench/window/mesh_frames.h"
#include "tests/bench/window/starts.h"

// In one run, in turn: the servo alone, and the servo beside a window that draws a moving stylus at 1280 x 800, that is
// dragged to other sizes, and that is given another scene every 200 ms; then a servo of 4 kHz beside the window,
// recorded and not (alone with the argument "recorded"). Each 10 s; the figures are of that time alone. With the
// argument "frames" only how many frames are drawn, and what one costs; with "meshes" only how long pictures of large
// meshes take; with "starts" only how long the program takes to its first picture, and its memory.
namespace underact::gui {
namespace {

constexpr int kPhase_ms = 10'000, kFrames_ms = 5'000;

QString scenePath(const char* name) {
  return QString(UNDERACT_SOURCE) + "/scenes/" + name + ".json";
}

void print(const char* phase, const servo::Percentiles& late, std::int64_t dropped) {
  std::printf("%-34s p50 %6.1f  p99 %6.1f  p99.9 %6.1f  max %8.1f us   dropped %lld\n", phase, late.p50_us, late.p99_us,
              late.p999_us, late.max_us, static_cast<long long>(dropped));
  std::fflush(stdout);
}

/// Runs the event loop for one phase; each(ms since its start) every 8 ms.
void pass(const std::function<void(double)>& each, int phase_ms = kPhase_ms) {
  QElapsedTimer clock;
  clock.start();
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &timer, [&] { each(static_cast<double>(clock.nsecsElapsed()) * 1e-6); });
  timer.start(8);
  QEventLoop loop;  // quit() of the program would close the window
  QTimer::singleShot(phase_ms, &loop, &QEventLoop::quit);
  loop.exec();
}

/// The hand on a circle of 45 mm, in and out of the sphere, once in 2 s.
void moveHand(device::SimulatedArm& arm, double ms) {
  const double angle_rad = ms * 3.14e-3;
  sim::HandSetpoint setpoint;
  setpoint.p_WT = {0.045 * std::cos(angle_rad), 0.02 * std::sin(2 * angle_rad), 0.03 + 0.03 * std::sin(angle_rad)};
  arm.setSetpoint(setpoint);
}

void measureAlone() {
  SimulatedHost alone = makeSimulatedHost({});
  alone.host->load(scene::readSceneFile(scenePath("02_sphere").toStdString()).value());
  alone.host->start();
  pass([&](double ms) {
    moveHand(*alone.arm, ms);
    alone.host->drain([](const servo::TickRecord&) {});
  });
  print("servo alone", alone.host->timing().lateLately(), alone.host->snapshot().dropped);
}

void measureWithWindow(bool first_round) {
  SimulatedHost simulated = makeSimulatedHost({});
  ThemeWatcher theme;
  MainWindow window({*simulated.host, simulated.arm, theme});
  window.resize(1280, 800);
  QElapsedTimer since_show;
  since_show.start();
  double first_ms = 0.0;
  QObject::connect(&window.view(), &SceneView::drawn, &window, [&](double) {
    if (first_ms == 0.0) first_ms = static_cast<double>(since_show.nsecsElapsed()) * 1e-6;
  });
  window.show();
  window.actions().perform("scene.open", scenePath("02_sphere"));
  window.actions().perform("session.start");
  const auto dropped = [&] { return simulated.host->snapshot().dropped; };

  const qint64 before = window.view().framesDrawn();
  pass([&](double ms) { moveHand(*simulated.arm, ms); });
  print("with the window drawing", simulated.host->timing().lateLately(), dropped());
  std::printf("%-34s %.1f frames/s at %d x %d, first picture %.0f ms after show, %s\n", "",
              static_cast<double>(window.view().framesDrawn() - before) * 1e3 / kPhase_ms, window.width(),
              window.height(), first_ms, window.view().graphicsName().toUtf8().constData());
  if (!first_round) return;

  auto* const surface = window.view().findChild<GlSurface*>();
  surface->setOcclusion(true);
  const qint64 without = window.view().framesDrawn();
  pass([&](double ms) { moveHand(*simulated.arm, ms); });
  print("with ambient occlusion", simulated.host->timing().lateLately(), dropped());
  std::printf("%-34s %.1f frames/s\n", "",
              static_cast<double>(window.view().framesDrawn() - without) * 1e3 / kPhase_ms);
  surface->setOcclusion(false);

  pass([&](double ms) {
    moveHand(*simulated.arm, ms);
    window.resize(1280 + static_cast<int>(ms / 16) % 200, 800 + static_cast<int>(ms / 24) % 100);
    window.move(static_cast<int>(ms / 16) % 300, static_cast<int>(ms / 24) % 100);
  });
  print("with the window dragged and sized", simulated.host->timing().lateLately(), dropped());

  const char* scenes[] = {"01_point", "02_sphere", "05_circle", "06_cylinder", "07_box_outside"};
  int loads = 0;
  pass([&](double ms) {
    moveHand(*simulated.arm, ms);
    if (static_cast<int>(ms / 200) > loads) window.actions().perform("scene.open", scenePath(scenes[++loads % 5]));
  });
  print("with a scene loaded every 200 ms", simulated.host->timing().lateLately(), dropped());
}

/// Frames a second, and the processor time that each costs the whole program: that hardly depends on what else runs.
void measureFramesAlone() {
  SimulatedHost simulated = makeSimulatedHost({});
  ThemeWatcher theme;
  MainWindow window({*simulated.host, simulated.arm, theme});
  window.resize(1280, 800);
  window.show();
  window.actions().perform("scene.open", scenePath("02_sphere"));
  window.actions().perform("session.start");
  double drawing_ms = 0.0;
  QObject::connect(&window.view(), &SceneView::drawn, &window, [&](double frame_ms) { drawing_ms += frame_ms; });
  for (int round = 0; round < 3; ++round) {
    drawing_ms = 0.0;
    const qint64 before = window.view().framesDrawn();
    const std::clock_t used = std::clock();
    pass([&](double ms) { moveHand(*simulated.arm, ms); }, kFrames_ms);
    const auto frames = static_cast<double>(std::max<qint64>(window.view().framesDrawn() - before, 1));
    std::printf("%5.1f frames/s, the view's drawing %.1f ms each, %.1f ms of processor time each\n",
                1e3 * frames / kFrames_ms, drawing_ms / frames,
                1e3 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / frames);
    std::fflush(stdout);
  }
}

/// A session of a 4 kHz servo beside the window: no tick may be missing in it.
void measureRecorded() {
  const QTemporaryDir folder;
  SimulatedHost simulated = makeSimulatedHost({.rate_hz = 4000});
  ThemeWatcher theme;
  MainWindow window({*simulated.host, simulated.arm, theme});
  window.resize(1280, 800);
  window.show();
  window.actions().perform("scene.open", scenePath("02_sphere"));
  window.actions().perform("session.start");
  for (const bool recorded : {false, true}) {
    std::unique_ptr<record::Recorder> recorder;
    if (recorded)
      recorder = record::Recorder::start(*simulated.host, folder.filePath("s.h5").toStdString(), {}).value();
    pass([&](double ms) { moveHand(*simulated.arm, ms); });
    print(recorded ? "4 kHz, window drawing, recorded" : "4 kHz, window drawing", simulated.host->timing().lateLately(),
          simulated.host->snapshot().dropped);
    if (!recorder) continue;
    recorder->stop();
    const record::RecorderStatus status = recorder->status();
    std::printf("%-34s %lld ticks in the session, %lld dropped, %.1f MB\n", "", static_cast<long long>(status.ticks),
                static_cast<long long>(status.dropped), 1e-6 * static_cast<double>(status.bytes));
  }
}

void measureAll() {
  {
    SimulatedHost host = makeSimulatedHost({});
    std::printf("scheduling %s, %d Hz\n", host.host->scheduling().name.c_str(), host.host->rateHz());
  }
  for (int round = 0; round < 3; ++round) {
    measureAlone();
    measureWithWindow(round == 0);
  }
  measureRecorded();
}

}  // namespace
}  // namespace underact::gui

int main(int argc, char** argv) {
  QTemporaryDir settings;
  qputenv("UNDERACT_MESH_READER", UNDERACT_MESH_READER);
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  QSurfaceFormat::setDefaultFormat(underact::gui::surfaceFormat());
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  QApplication::setQuitOnLastWindowClosed(false);
  std::setlocale(LC_NUMERIC, "C");
  if (argc > 1 && std::string_view(argv[1]) == "meshes") {
    underact::gui::measureMeshFrames(UNDERACT_SOURCE);
  } else if (argc > 1 && std::string_view(argv[1]) == "starts") {
    underact::gui::measureStarts();
  } else if (argc > 1 && std::string_view(argv[1]) == "frames") {
    underact::gui::measureFramesAlone();
  } else if (argc > 1 && std::string_view(argv[1]) == "recorded") {
    underact::gui::measureRecorded();
  } else {
    underact::gui::measureAll();
  }
  return 0;
}
