#include <QElapsedTimer>
#include <QFileInfo>
#include <QIcon>
#include <QSurfaceFormat>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <string>
#include <utility>

#include "app/gui/kit/accessible_widgets.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/application.h"
#include "app/gui/kit/focus_style.h"
#include "app/gui/model/document.h"
#include "app/gui/model/file_kind.h"
#include "app/gui/model/language.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/film.h"
#include "app/gui/view/gl_surface.h"
#include "app/gui/view/picture.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/window_watch.h"
#include "app/options/window_options.h"
#include "core/system/current_folder.h"
#include "core/system/signals.h"
#include "core/system/this_process.h"
#include "device/input/controllers.h"
#include "device/input/space_mice.h"
#include "device/wooden_haptics/hid_bus.h"
#include "underact/version.h"

namespace underact::gui {
namespace {

// The last scene, else the sphere.
QString sceneOfLastTime() {
  const QString last = readSettings().last_scene;
  return QFileInfo::exists(last) ? last : firstScene(shippedScenes());
}

/// When main() began, by the clock and in CPU time.
struct Began {
  QElapsedTimer clock;
  std::clock_t processor = std::clock();
};

void printFirstPicture(const Began& began, double frame_ms) {
  const double processor_ms = 1e3 * static_cast<double>(std::clock() - began.processor) / CLOCKS_PER_SEC;
  std::fprintf(stderr, "first picture after %lld ms (%.0f ms of CPU time), drawn in %.1f ms\n", began.clock.elapsed(),
               processor_ms, frame_ms);
}

int endWithoutOpenGl() {
  const auto [found, found_minor] = foundOpenGl();
  const auto [needed, needed_minor] = surfaceFormat().version();
  const std::string offers =
      found == 0 ? "none, not even drawn by software" : std::to_string(found) + "." + std::to_string(found_minor);
  std::fprintf(stderr,
               "No OpenGL %d.%d: this display offers %s. Install its driver (Mesa for software),\n"
               "or use underact-cli, which needs none.\n",
               needed, needed_minor, offers.c_str());
  return 2;
}

QString qts_words;  // what Qt said while it looked for a display

/// Without a display, Qt would abort, leave a core file, and advise to install the program again.
void holdQtsWords(QtMsgType type, const QMessageLogContext& context, const QString& words) {
  if (type == QtFatalMsg) {
    std::fprintf(stderr,
                 "No display that can be used (DISPLAY=%s, WAYLAND_DISPLAY=%s).\n"
                 "Use underact-cli, which needs none, or start Xvfb. Qt says:\n%s",
                 qgetenv("DISPLAY").constData(), qgetenv("WAYLAND_DISPLAY").constData(), qUtf8Printable(qts_words));
    system::end(2);
  }
  qts_words += qFormatLogMessage(type, context, words) + '\n';
}

int runWindow(const options::WindowOptions& options, const Began& began) {
  SimulatedHost simulated = makeSimulatedHost({.rate_hz = options.rate_hz.value_or(readSettings().servo_rate_hz),
                                               .scheduling = options.scheduling,
                                               .max_late = options.max_late});
  ThemeWatcher theme;
  device::input::Controllers controllers;
  device::input::SpaceMice space_mice(device::hidapiBus());
  MainWindow window({*simulated.host,
                     simulated.arm,
                     theme,
                     simulated.replay,
                     simulated.chosen,
                     {&controllers, &space_mice},
                     WindowWatch::kLimit_s});
  if (!hasOpenGl()) return endWithoutOpenGl();
  if (qEnvironmentVariableIsSet("UNDERACT_TIMING")) {
    QObject::connect(&window.view(), &SceneView::drawn, &window, [&began, first = true](double frame_ms) mutable {
      if (std::exchange(first, false)) printFirstPicture(began, frame_ms);
    });
  }
  window.show();
  const QString asked = QString::fromStdString(options.file);
  const Result<FileKind> kind = kindOfFile(options.file);
  const bool is_scene = kind && kind.value() == FileKind::Scene;
  const QString scene = is_scene ? asked : sceneOfLastTime();
  if (!scene.isEmpty()) window.actions().perform("scene.open", scene);
  // Nobody holds a simulated arm, so it may push at once. A real one waits for Start.
  if (simulated.host->device().simulated && !window.actions().perform("session.start")) {
    // The scene's meshes are still loading.
    QObject::connect(&window.document(), &Document::opened, &window, [&window, &simulated, first = true]() mutable {
      const bool is_nobodys = simulated.host->device().simulated;
      if (std::exchange(first, false) && is_nobodys) window.actions().perform("session.start");
    });
  }
  const QString device = options.device.empty() ? readSettings().device : QString::fromStdString(options.device);
  if (!device.isEmpty() && device != "simulated") window.actions().perform("devices.use", device);
  if (!asked.isEmpty() && !is_scene) window.actions().perform("scene.open", asked);  // beside the scene, or refused
  if (options.visitors) {
    QStringList scenes;
    for (const std::string& path : options.visitor_scenes) {
      if (!path.empty()) scenes << QString::fromStdString(path);  // "--visitor" alone gives an empty one
    }
    window.actions().perform("visitor.start", scenes);
  }
  // The handler itself ends the force; the window follows when its thread comes to it.
  const system::Interrupt interrupt(system::Reader::MayGo, &simulated.host->stops());
  QTimer ends;
  QObject::connect(&ends, &QTimer::timeout, [&interrupt] {
    if (interrupt.came()) QApplication::exit(0);
  });
  ends.start(50);
  return QApplication::exec();
}

int run(int argc, char** argv) {
  Began began;
  began.clock.start();
  system::returnLargeBlocks();
  const options::WindowOptions options = options::parseWindowOptions({argv + 1, argv + argc});
  if (!options.given.empty()) {
    std::fputs(options.given.c_str(), options.exit == 0 ? stdout : stderr);
    return options.exit;
  }
  QSurfaceFormat::setDefaultFormat(surfaceFormat());
  QApplication::setOrganizationName("Underact");
  QApplication::setApplicationName("underact");
  QApplication::setApplicationVersion(kVersion);
  QApplication::setDesktopFileName("org.underact.underact");
  qInstallMessageHandler(holdQtsWords);
  Application application(argc, argv);
  qInstallMessageHandler(nullptr);
  std::fputs(qUtf8Printable(qts_words), stderr);
  QApplication::setWindowIcon(QIcon::fromTheme("underact"));  // if it is installed
  QApplication::setStyle(new FocusStyle);
  makeWidgetsAccessible();
  if (!options.film.empty()) {
    speak(chosenLanguage());
    const QSize size = filmSize(options.film_size);
    if (size.isEmpty()) {
      std::fputs("--size needs two even numbers from 64 to 4096, as 1280x720.\n", stderr);
      return 2;
    }
    const int exit = makeFilm({options.film, options.out, options.film_hand, options.film_seconds, options.film_speed,
                               options.film_fps, size, options.overwrite, options.progress_lines});
    return hasOpenGl() || exit == 2 ? exit : endWithoutOpenGl();
  }
  // Pictures are for the guide.
  speak(options.picture.empty() && options.small_pictures.empty() ? chosenLanguage() : "en");
  if (!options.picture.empty() || !options.small_pictures.empty()) {
    const int exit =
        options.picture.empty() ? drawSmallPictures(options.small_pictures) : drawPicture(options.picture, options.out);
    return hasOpenGl() ? exit : endWithoutOpenGl();
  }
  return runWindow(options, began);
}

}  // namespace
}  // namespace underact::gui

int main(int argc, char** argv) {
  underact::system::keepOutCurrentFolder();
  underact::system::reportFullFiles();
  return underact::gui::run(argc, argv);
}
