#include "app/gui/visitor/visitor_settings.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>

#include "app/gui/model/scene_library.h"
#include "app/gui/model/settings.h"

namespace underact::gui {
namespace {

// Each feels different, and none needs an explanation first.
constexpr const char* kDefault[] = {"02_sphere.json",           "07_box_outside.json",         "05_circle.json",
                                    "14_circle_influence.json", "10_two_spheres_nearest.json", "25_torus_knot.json",
                                    "26_bumpy_sphere.json",     "28_trefoil_path.json"};

QStringList existing(const QStringList& paths) {
  QStringList there;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(there),
               [](const QString& path) { return QFileInfo::exists(path); });
  return there;
}

QStringList defaultScenes() {
  QStringList paths;
  for (const char* name : kDefault) paths << QDir(sceneFolder()).filePath(name);
  return existing(paths);
}

}  // namespace

VisitorSettings readVisitorSettings() {
  VisitorSettings visitor_settings;
  if (!readSettings().are_newer) {
    const QSettings stored;
    visitor_settings.scenes = existing(stored.value("visitor/scenes").toStringList());
    visitor_settings.dwell_s = std::clamp(stored.value("visitor/dwell_s", visitor_settings.dwell_s).toInt(),
                                          kShortestDwell_s, kLongestDwell_s);
    visitor_settings.force_percent =
        std::clamp(stored.value("visitor/force_percent", visitor_settings.force_percent).toInt(), kMinForce_percent,
                   kMaxForce_percent);
  }
  if (visitor_settings.scenes.isEmpty()) visitor_settings.scenes = defaultScenes();
  return visitor_settings;
}

void writeVisitorSettings(const VisitorSettings& visitor_settings) {
  if (readSettings().are_newer) return;
  QSettings stored;
  stored.setValue("visitor/scenes", visitor_settings.scenes);
  stored.setValue("visitor/dwell_s", visitor_settings.dwell_s);
  stored.setValue("visitor/force_percent", visitor_settings.force_percent);
}

}  // namespace underact::gui
