#include "app/gui/model/settings.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

#include "core/servo/device_port.h"

namespace underact::gui {
namespace {

QString keyOf(const lesson::Layer& layer) {
  return QString("layers/%1").arg(layer.name);
}

const QString kLayouts = "window/layouts/";
constexpr const char* kSectionKeys[] = {"layers/section_x_mm", "layers/section_y_mm", "layers/section_z_mm"};

}  // namespace

Settings readSettings() {
  const QSettings stored;
  const Settings fresh;
  Settings settings;
  settings.are_newer = stored.value("settings/version", kSettingsVersion).toInt() > kSettingsVersion;
  if (settings.are_newer) return settings;
  settings.geometry = stored.value("window/geometry").toByteArray();
  settings.purpose = stored.value("window/purpose").toString();
  for (const QString& key : stored.allKeys()) {
    if (key.startsWith(kLayouts)) settings.layouts[key.sliced(kLayouts.size())] = stored.value(key).toByteArray();
  }
  const QString theme = stored.value("window/theme").toString();
  settings.theme = theme == "light" ? ThemeChoice::Light : theme == "dark" ? ThemeChoice::Dark : ThemeChoice::System;
  for (const lesson::Layer& layer : lesson::layers()) {
    settings.layers.*layer.shown = stored.value(keyOf(layer), fresh.layers.*layer.shown).toBool();
  }
  settings.layers.section_axis =
      std::clamp(stored.value("layers/section_axis", fresh.layers.section_axis).toInt(), 0, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const double at_mm = stored.value(kSectionKeys[axis]).toDouble();
    settings.layers.section_mm[axis] = std::isfinite(at_mm) ? at_mm : 0.0;
  }
  settings.recent = stored.value("files/recent").toStringList();
  settings.last_scene = stored.value("files/last").toString();
  settings.plot_axis = std::clamp(stored.value("plots/axis", 0).toInt(), 0, 2);
  settings.energy_plot = stored.value("plots/energy", fresh.energy_plot).toBool();
  settings.hold_to_run = stored.value("servo/hold_to_run", fresh.hold_to_run).toBool();
  settings.keeps_holding = stored.value("hand/keeps_holding", fresh.keeps_holding).toBool();
  settings.arm_model = stored.value("arm/model").toString();
  settings.device = stored.value("arm/device").toString();
  const int rate_hz = stored.value("servo/rate_hz", fresh.servo_rate_hz).toInt();
  if (rate_hz >= servo::kSlowest_hz && rate_hz <= servo::kFastest_hz) settings.servo_rate_hz = rate_hz;
  settings.guide_page = stored.value("guide/page").toString();
  settings.guide_zoom = std::clamp(stored.value("guide/zoom", fresh.guide_zoom).toInt(), 50, 300);
  settings.has_pushed = stored.value("hints/has_pushed", false).toBool();
  settings.projector = stored.value("window/projector", false).toBool();
  settings.left_handed = stored.value("scene/left_handed", false).toBool();
  return settings;
}

void writeSettings(const Settings& settings) {
  if (settings.are_newer) return;
  QSettings stored;
  stored.setValue("settings/version", kSettingsVersion);
  stored.setValue("window/geometry", settings.geometry);
  stored.setValue("window/purpose", settings.purpose);
  for (auto one = settings.layouts.begin(); one != settings.layouts.end(); ++one)
    stored.setValue(kLayouts + one.key(), one.value());
  stored.setValue("window/theme", settings.theme == ThemeChoice::Light  ? "light"
                                  : settings.theme == ThemeChoice::Dark ? "dark"
                                                                        : "system");
  for (const lesson::Layer& layer : lesson::layers()) stored.setValue(keyOf(layer), settings.layers.*layer.shown);
  stored.setValue("layers/section_axis", settings.layers.section_axis);
  for (int axis = 0; axis < 3; ++axis) stored.setValue(kSectionKeys[axis], settings.layers.section_mm[axis]);
  stored.setValue("files/recent", settings.recent);
  stored.setValue("files/last", settings.last_scene);
  stored.setValue("plots/axis", settings.plot_axis);
  stored.setValue("plots/energy", settings.energy_plot);
  stored.setValue("servo/hold_to_run", settings.hold_to_run);
  stored.setValue("hand/keeps_holding", settings.keeps_holding);
  stored.setValue("arm/model", settings.arm_model);
  stored.setValue("arm/device", settings.device);
  stored.setValue("servo/rate_hz", settings.servo_rate_hz);
  stored.setValue("guide/page", settings.guide_page);
  stored.setValue("guide/zoom", settings.guide_zoom);
  stored.setValue("hints/has_pushed", settings.has_pushed);
  stored.setValue("window/projector", settings.projector);
  stored.setValue("scene/left_handed", settings.left_handed);
}

}  // namespace underact::gui
