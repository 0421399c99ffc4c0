#include "app/gui/view/view_memory.h"

#include <QSettings>
#include <array>
#include <cmath>
#include <optional>

#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

const QString kViewsKey = QStringLiteral("view/of_scenes");

QString rowOf(const QString& path, const Viewpoint& viewpoint) {
  const OrbitCamera& camera = viewpoint.camera;
  QStringList words;
  for (const double number : {camera.focus_mm.x(), camera.focus_mm.y(), camera.focus_mm.z(), camera.distance_mm,
                              camera.azimuth_rad, camera.elevation_rad})
    words << QString::number(number, 'g', 9);
  words << QString::number(camera.parallel ? 1 : 0) << QString::number(viewpoint.fits ? 1 : 0);
  return path + QLatin1Char('\t') + words.join(QLatin1Char(' '));
}

/// None: it is damaged. The desk's frame is that of `now`.
std::optional<Viewpoint> viewpointOf(const QString& row, const Viewpoint& now) {
  const QStringList words = row.section(QLatin1Char('\t'), 1).split(QLatin1Char(' '));
  std::array<double, 8> numbers{};
  if (words.size() != static_cast<int>(numbers.size())) return {};
  for (std::size_t index = 0; index < numbers.size(); ++index) {
    bool is_number = false;
    numbers[index] = words[static_cast<int>(index)].toDouble(&is_number);
    if (!is_number || !std::isfinite(numbers[index])) return {};
  }
  if (numbers[3] <= 0.0) return {};
  Viewpoint viewpoint = now;
  viewpoint.camera.focus_mm = Vec3(numbers[0], numbers[1], numbers[2]);
  viewpoint.camera.distance_mm = numbers[3];
  viewpoint.camera.azimuth_rad = numbers[4];
  viewpoint.camera.elevation_rad = numbers[5];
  viewpoint.camera.parallel = numbers[6] != 0.0;
  viewpoint.fits = numbers[7] != 0.0;
  return viewpoint;
}

int indexOf(const QStringList& rows, const QString& path) {
  for (int index = 0; index < rows.size(); ++index) {
    if (rows[index].startsWith(path + QLatin1Char('\t'))) return index;
  }
  return -1;
}

}  // namespace

ViewMemory::ViewMemory(SceneView& view) : view_(view), rows_(QSettings().value(kViewsKey).toStringList()) {}

void ViewMemory::enter(const QString& path) {
  if (path == path_) return;
  keep();
  path_ = path;
  const Viewpoint now = view_.viewpoint();
  const int index = path.isEmpty() ? -1 : indexOf(rows_, path);
  const std::optional<Viewpoint> kept = index < 0 ? std::nullopt : viewpointOf(rows_[index], now);
  if (kept) {
    view_.setViewpoint(*kept);
  } else if (!path.isEmpty() && !now.fits) {  // the last scene's view is not this one's
    view_.setViewpoint({now.camera, true});
  }
}

void ViewMemory::keep() {
  if (path_.isEmpty()) return;
  const Viewpoint viewpoint = view_.viewpoint();
  const int index = indexOf(rows_, path_);
  if (index >= 0) rows_.removeAt(index);
  if (!viewpoint.fits || viewpoint.camera.parallel) rows_.prepend(rowOf(path_, viewpoint));
  while (rows_.size() > kMax) rows_.removeLast();
  QSettings().setValue(kViewsKey, rows_);
}

}  // namespace underact::gui
