#include "app/gui/feature/feature.h"

#include <QMainWindow>
#include <memory>
#include <utility>

#include "app/gui/curve/curve_dialog.h"
#include "app/gui/files/constraint_files.h"
#include "app/gui/kit/words.h"
#include "core/curve/points.h"
#include "core/scene/compile.h"

namespace underact::gui {
namespace {

const QStringList kCurveSuffixes{"txt", "csv", "tsv", "xyz", "pts", "asc", "dat"};

Result<ConstraintFileKind::Ask> readCurve(const QString& path, const TaskMonitor& monitor) {
  Result<std::vector<Vec3>> read = curve::readPoints(path.toStdString(), monitor);
  if (!read) return read.problems();
  return ConstraintFileKind::Ask(
      [path, points = std::make_shared<const std::vector<Vec3>>(std::move(read).value())](
          bool can_add, QWidget* parent) { return new CurveDialog(path, points, can_add, parent); });
}

Result<ConstraintFileKind::Made> makePath(const scene::Shape& shape) {
  Result<target::CurvePath> path = scene::makeCurvePath(std::get<scene::Curve>(shape));
  if (!path) return path.problems();
  return ConstraintFileKind::Made(std::make_shared<const target::CurvePath>(std::move(path).value()));
}

void makeCurve(const FeatureParts& parts, ServoListeners&) {
  auto* files = new ConstraintFiles({.key = "curve",
                                     .suffixes = kCurveSuffixes,
                                     .choose = tr("Add a curve"),
                                     .filter = tr("Points (%1);;All files (*)"),
                                     .not_loaded = tr("Curve not loaded"),
                                     .edit = tr("curve %1"),
                                     .about = tr("The curve %1."),
                                     .read = readCurve,
                                     .make = makePath},
                                    parts.document, parts.files, parts.loads, parts.window);
  files->addAction(parts.actions,
                   {"curve.add",
                    tr("Add &curve…"),
                    {},
                    tr("Loads a file of points and adds their curve to the scene, or makes a new scene of it."),
                    "curve"});
}

}  // namespace

FeatureRow curveFeature() {
  return {.pages = {{"dialog.add_curve", "curves"}, {"dialog.curve", "curves"}, {"dialog.curve_problems", "curves"}},
          .make = makeCurve,
          .opens = FileKind::Curve,
          .open_action = "curve.add"};
}

}  // namespace underact::gui
