#include "app/gui/curve/curve_files.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <optional>
#include <utility>

#include "app/gui/files/load_strip.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/view/file_constraint.h"
#include "core/curve/points.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

const QStringList& suffixes() {
  static const QStringList kAll{"txt", "csv", "tsv", "xyz", "pts", "asc", "dat"};
  return kAll;
}

QString filterText() {
  QStringList patterns;
  for (const QString& suffix : suffixes()) patterns << "*." + suffix << "*." + suffix.toUpper();
  return CurveFiles::tr("Points (%1);;All files (*)").arg(patterns.join(' '));
}

}  // namespace

bool isCurveFile(const QString& path) {
  return suffixes().contains(QFileInfo(path).suffix().toLower());
}

scene::Constraint constraintOf(const QString& path, std::shared_ptr<const std::vector<Vec3>> points,
                               const CurveWish& wish) {
  Vec3 low = points->front(), high = low;
  for (const Vec3& p : *points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  scene::Curve curve;
  curve.file = QFileInfo(path).absoluteFilePath().toStdString();
  curve.scale_mm_per_unit = wish.mm_per_unit;
  curve.kind = wish.kind;
  curve.closed = wish.closed;
  curve.points = std::move(points);
  curve.X_WM = placeWithin(0.5 * wish.mm_per_unit * (low + high));
  scene::Constraint constraint;
  constraint.name = QFileInfo(path).completeBaseName().toStdString();
  constraint.shape = std::move(curve);
  return constraint;
}

CurveFiles::CurveFiles(Document& document, SceneFiles& scenes, LoadStrip& loads, QWidget* window)
    : QObject(window), document_(document), scenes_(scenes), loads_(loads), window_(window) {}

void CurveFiles::chooseAndAdd() {
  askForFile(window_, "dialog.add_curve", tr("Add a curve"), {}, filterText(),
             [this](const QString& path) { add(path); });
}

void CurveFiles::add(const QString& path) {
  const auto read = std::make_shared<std::optional<Result<std::vector<Vec3>>>>();
  loads_.begin(
      tr("Loading %1").arg(QFileInfo(path).fileName()),
      [read, file = path.toStdString()](const Watch& watch) { *read = curve::readPoints(file, watch); },
      [this, read, path] {
        if (**read) {
          ask(path, std::make_shared<const std::vector<Vec3>>((**read).value()));
          return;
        }
        const QString what = tr("“%1” was not loaded. The scene stays as it is.").arg(QFileInfo(path).fileName());
        showProblemsBox("dialog.curve_problems", tr("Curve not loaded"), what, (**read).problems(), window_);
      });
}

void CurveFiles::ask(const QString& path, const Points& points) {
  auto* dialog = new CurveDialog(path, points, document_.isOpen(), window_);
  connect(dialog, &CurveDialog::addAsked, this, [this, dialog, path, points] {
    make(path, points, dialog, [this, path](CurveDialog& asked, const scene::Constraint& constraint) {
      const scene::Description with = scene::withAdded(document_.scene(), document_.throughMirror(constraint));
      const Problems problems =
          document_.edit(with, tr("curve %1").arg(QFileInfo(path).fileName()), document_.newGesture());
      asked.setRefusal(sentencesOf(problems));
      return problems.empty();
    });
  });
  connect(dialog, &CurveDialog::newSceneAsked, this, [this, dialog, path, points] {
    make(path, points, dialog, [this, path](CurveDialog&, const scene::Constraint& constraint) {
      return scenes_.openLoaded(sceneOfFile(path, tr("The curve %1.").arg(QFileInfo(path).fileName()), constraint));
    });
  });
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

// In another thread: what is then compiled in this one finds the curve made.
void CurveFiles::make(const QString& path, const Points& points, CurveDialog* dialog, const Use& use) {
  const scene::Constraint constraint = constraintOf(path, points, dialog->wish());
  const auto made = std::make_shared<std::optional<Result<target::CurvePath>>>();
  loads_.begin(
      tr("Adding %1").arg(QFileInfo(path).fileName()),
      [made, shown = document_.throughMirror(constraint)](const Watch&) {
        *made = scene::makeCurvePath(std::get<scene::Curve>(shown.shape));
      },
      [made, constraint, use, asked = QPointer<CurveDialog>(dialog)] {
        if (asked == nullptr) return;  // closed meanwhile: it is not wanted any more
        if (!**made) {
          asked->setRefusal(sentencesOf((**made).problems()));
        } else if (use(*asked, constraint)) {
          asked->close();
        }
      });
}

void addCurveActions(Actions& actions, CurveFiles& files) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("underact::gui", text); };
  actions.add({"curve.add", tr("Add &curve…"), QKeySequence("Ctrl+Shift+C"),
               tr("Loads a file of points, and adds their curve to the scene or makes a new one of it."), "curve"},
              [&files](const QVariantList& path) {
                if (path.isEmpty())
                  files.chooseAndAdd();
                else
                  files.add(path.first().toString());
                return true;
              });
}

}  // namespace underact::gui
