#include "app/gui/view/picture.h"

#include <QDir>
#include <QFileInfo>
#include <cstdio>

#include "app/gui/model/scene_library.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/gl_surface.h"
#include "app/gui/view/scene_view.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/scene/scene_arm.h"
#include "device/simulated_arm.h"

namespace underact::gui {
namespace {

constexpr QSize kSize(1280, 960);
constexpr int kFiner = 4;           // a small picture is first drawn this much larger: smooth edges on any machine
constexpr int kPictureMargin = 16;  // around what is drawn, then

Result<QImage> pictureOf(const std::string& scene_file, QSize size, const Theme& theme, bool with_words) {
  Result<scene::Description> scene = scene::readSceneFile(scene_file);
  SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
  Problems problems = scene ? scene::loadMeshes(scene.value()) : scene.problems();
  if (problems.empty()) problems = simulated.host->load(scene.value());
  if (!problems.empty()) return problems;
  const arm::Preset& arm = scene::armOf(scene.value());
  simulated.arm->become(arm);
  simulated.host->run(1);  // the stylus is drawn where the arm says that it is
  SceneView view;
  view.setAttribute(Qt::WA_DontShowOnScreen);
  view.resize(size);
  view.setTheme(theme);
  view.showWords(with_words);
  // Of a scene for another arm the arm is what it shows.
  if (!with_words) view.setLayers({.workspace = false, .triads = false, .arm = !arm::isDevice(arm)});
  view.setScene(scene.value());
  view.present(simulated.host->snapshot());
  view.show();  // now: a view that is seen would take its time to turn to another arm's desk
  return view.picture();
}

/// The part that is not empty, in the proportions of the small picture.
QImage cropped(const QImage& image) {
  const QRgb ground = image.pixel(0, 0);
  QRect drawn;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixel(x, y) != ground) drawn |= QRect(x, y, 1, 1);
    }
  }
  const QSize room = drawn.size() + QSize(2 * kPictureMargin, 2 * kPictureMargin);
  QRect part(QPoint(), kSmallPicture.scaled(room, Qt::KeepAspectRatioByExpanding).boundedTo(image.size()));
  part.moveCenter(drawn.center());
  part.moveLeft(qBound(0, part.left(), image.width() - part.width()));
  part.moveTop(qBound(0, part.top(), image.height() - part.height()));
  return image.copy(part);
}

int told(const Problems& problems) {
  for (const Problem& problem : problems) std::fprintf(stderr, "%s\n", describe(problem).c_str());
  return problems.front().place.line == 0 ? 4 : 1;
}

int save(const QImage& image, const QString& out) {
  if (!image.isNull() && image.save(out, "PNG")) return 0;
  if (!hasOpenGl()) return 2;  // which is said elsewhere
  std::fprintf(stderr, "%s cannot be written.\n", out.toStdString().c_str());
  return 4;
}

}  // namespace

Result<QImage> smallPicture(const std::string& scene_file, const Theme& theme) {
  const Result<QImage> drawn = pictureOf(scene_file, kFiner * kSmallPicture, theme, false);
  if (!drawn) return drawn.problems();
  return cropped(drawn.value()).scaled(kSmallPicture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

int drawPicture(const std::string& scene_file, const std::string& out) {
  const Result<QImage> drawn = pictureOf(scene_file, kSize, Theme::light(), true);
  return drawn ? save(drawn.value(), QString::fromStdString(out)) : told(drawn.problems());
}

int drawSmallPictures(const std::string& folder) {
  const QDir out(QString::fromStdString(folder));
  if (!out.mkpath(".")) return save({}, out.path());
  for (const SceneEntry& entry : shippedScenes()) {
    for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
      const Result<QImage> drawn = smallPicture(entry.path.toStdString(), theme);
      const QString name = QFileInfo(entry.path).completeBaseName() + (theme.dark ? "_dark.png" : ".png");
      const int status = drawn ? save(drawn.value(), out.filePath(name)) : told(drawn.problems());
      if (status != 0) return status;
    }
  }
  return 0;
}

}  // namespace underact::gui
