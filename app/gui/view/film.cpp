#include "app/gui/view/film.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "app/gui/kit/words.h"
#include "app/gui/model/file_kind.h"
#include "app/gui/model/settings.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/film_encoder.h"
#include "app/gui/view/scene_view.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/scene/scene_arm.h"
#include "core/sim/hand_script.h"
#include "core/system/signals.h"
#include "core/system/this_process.h"
#include "device/recorded.h"

namespace underact::gui {
namespace {

constexpr int kErrors = 2;  // the descriptor of stderr
constexpr int kMin_px = 64, kMax_px = 4096;

int say(int exit, const QString& sentence) {
  std::fprintf(stderr, "%s\n", qUtf8Printable(sentence));
  return exit;
}

int say(const Problems& problems) {
  for (const Problem& problem : problems) std::fprintf(stderr, "%s\n", describe(problem).c_str());
  return problems.front().place.line == 0 ? 4 : 1;
}

bool isSession(const std::string& file) {
  const Result<FileKind> kind = kindOfFile(file);
  return kind && kind.value() == FileKind::Session;
}

/// What is filmed, on a servo that ticks when it is told to.
struct Subject {
  SimulatedHost simulated;
  std::shared_ptr<const device::Recorded> recorded;  // null: a scene
  const device::RecordedScene* shown = nullptr;
  std::int64_t ticks = 0;  // of all of it
};

Problems show(Subject& subject, SceneView& view, scene::Description scene) {
  Problems problems = scene::loadMeshes(scene);
  if (problems.empty()) problems = subject.simulated.host->load(scene);
  if (problems.empty()) view.setScene(scene);
  return problems;
}

Problems beginScene(const FilmOptions& options, Subject& subject, SceneView& view) {
  Result<scene::Description> scene = scene::readSceneFile(options.file);
  if (!scene) return scene.problems();
  const bool is_file = options.hand.find_first_of("./\\") != std::string::npos;
  Result<sim::HandScript> hand = is_file ? sim::readHandFile(options.hand) : sim::builtInHand(options.hand, 0);
  if (!hand) return hand.problems();
  const arm::Preset& arm = scene::armOf(scene.value());
  subject.simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
  subject.simulated.arm->follow(sim::madeFor(arm, std::move(hand).value()));
  subject.simulated.arm->become(arm);
  subject.ticks = std::llround(1000.0 * options.seconds);
  return show(subject, view, std::move(scene).value());
}

Problems beginSession(const FilmOptions& options, Subject& subject, SceneView& view) {
  Result<std::shared_ptr<const device::Recorded>> recorded = device::loadRecorded(options.file);
  if (!recorded) return recorded.problems();
  subject.recorded = std::move(recorded).value();
  subject.simulated = makeSimulatedHost({.rate_hz = subject.recorded->rate_hz, .clock = servo::Clock::Manual});
  subject.simulated.replay->replay(subject.recorded);
  subject.simulated.replay->play();
  subject.ticks = static_cast<std::int64_t>(subject.recorded->rows.size());
  subject.shown = subject.recorded->sceneAt(0);
  return subject.shown == nullptr ? Problems{} : show(subject, view, subject.shown->scene);
}

/// The scene that is in effect at a tick of a session.
Problems follow(Subject& subject, SceneView& view, std::int64_t tick) {
  if (subject.recorded == nullptr) return {};
  const device::RecordedScene* const now = subject.recorded->sceneAt(tick);
  if (now == nullptr || now == std::exchange(subject.shown, now)) return {};
  return show(subject, view, now->scene);
}

void showProgress(int percent, bool in_lines, int& shown) {
  if (percent == std::exchange(shown, percent)) return;
  if (in_lines) {
    std::fprintf(stderr, "%d\n", percent);
  } else if (system::isTerminal(kErrors)) {
    std::fprintf(stderr, "\r%d %%%s", percent, percent == 100 ? "\n" : "");
  }
}

int film(const FilmOptions& options, Subject& subject, SceneView& view, FilmEncoder& encoder) {
  const system::Interrupt interrupt;
  const double per_picture = options.speed * (subject.recorded ? subject.recorded->rate_hz : 1000) / options.fps;
  const auto pictures = static_cast<std::int64_t>(std::ceil(static_cast<double>(subject.ticks) / per_picture));
  std::int64_t tick = 0;
  int percent = -1;
  subject.simulated.host->start();
  for (std::int64_t number = 0; number < pictures; ++number) {
    if (interrupt.came()) return say(4, tr("Interrupted: no film was written."));
    const std::int64_t until = std::max<std::int64_t>(1, std::llround(static_cast<double>(number) * per_picture));
    if (const Problems problems = follow(subject, view, until); !problems.empty()) return say(problems);
    subject.simulated.host->run(static_cast<int>(until - std::exchange(tick, until)));
    subject.simulated.host->drain([](const servo::TickRecord&) {});
    view.present(subject.simulated.host->snapshot());
    const QImage picture = view.picture().scaled(options.size);
    if (const QString why = encoder.add(picture); !why.isEmpty()) return say(4, why);
    showProgress(static_cast<int>(100 * (number + 1) / pictures), options.progress_lines, percent);
  }
  const QString why = encoder.finish();
  return why.isEmpty() ? 0 : say(4, why);
}

}  // namespace

QSize filmSize(const std::string& text) {
  static const QRegularExpression kSize("^(\\d{1,5})x(\\d{1,5})$");
  const QRegularExpressionMatch found = kSize.match(QString::fromStdString(text));
  const QSize size(found.captured(1).toInt(), found.captured(2).toInt());
  const auto fits = [](int px) { return px >= kMin_px && px <= kMax_px && px % 2 == 0; };
  return fits(size.width()) && fits(size.height()) ? size : QSize();
}

int makeFilm(const FilmOptions& options) {
  const QString out = QString::fromStdString(options.out);
  if (!isFilmName(out)) return say(2, tr("A film is a file.webm, file.mp4 or file.gif."));
  if (QFileInfo::exists(out) && !options.overwrite) return say(4, tr("%1 exists. --overwrite replaces it.").arg(out));
  Subject subject;
  SceneView view;
  view.setAttribute(Qt::WA_DontShowOnScreen);
  view.resize(options.size);
  view.setTheme(Theme::light());
  view.setLayers(quietLayers());
  const Problems problems =
      isSession(options.file) ? beginSession(options, subject, view) : beginScene(options, subject, view);
  if (!problems.empty()) return say(problems);
  subject.simulated.host->run(1);
  view.present(subject.simulated.host->snapshot());
  view.show();
  FilmEncoder encoder;
  if (const QString why = encoder.begin(out, options.size, options.fps); !why.isEmpty()) return say(4, why);
  return film(options, subject, view, encoder);
}

}  // namespace underact::gui
