#include "app/gui/settings.h"

#include <QSettings>
#include <algorithm>

namespace underact::gui {

Settings readSettings() {
  const QSettings stored;
  const Settings fresh;
  Settings settings;
  settings.geometry = stored.value("window/geometry").toByteArray();
  settings.layout = stored.value("window/layout").toByteArray();
  const QString theme = stored.value("window/theme").toString();
  settings.theme = theme == "light" ? ThemeChoice::Light : theme == "dark" ? ThemeChoice::Dark : ThemeChoice::System;
  settings.layers.workspace = stored.value("layers/workspace", fresh.layers.workspace).toBool();
  settings.layers.triads = stored.value("layers/triads", fresh.layers.triads).toBool();
  settings.layers.arm = stored.value("layers/arm", fresh.layers.arm).toBool();
  settings.layers.target = stored.value("layers/target", fresh.layers.target).toBool();
  settings.layers.force = stored.value("layers/force", fresh.layers.force).toBool();
  settings.recent = stored.value("files/recent").toStringList();
  settings.last_scene = stored.value("files/last").toString();
  settings.plot_axis = std::clamp(stored.value("plots/axis", 0).toInt(), 0, 2);
  settings.has_pushed = stored.value("hints/has_pushed", false).toBool();
  return settings;
}

void writeSettings(const Settings& settings) {
  QSettings stored;
  stored.setValue("window/geometry", settings.geometry);
  stored.setValue("window/layout", settings.layout);
  stored.setValue("window/theme", settings.theme == ThemeChoice::Light  ? "light"
                                  : settings.theme == ThemeChoice::Dark ? "dark"
                                                                        : "system");
  stored.setValue("layers/workspace", settings.layers.workspace);
  stored.setValue("layers/triads", settings.layers.triads);
  stored.setValue("layers/arm", settings.layers.arm);
  stored.setValue("layers/target", settings.layers.target);
  stored.setValue("layers/force", settings.layers.force);
  stored.setValue("files/recent", settings.recent);
  stored.setValue("files/last", settings.last_scene);
  stored.setValue("plots/axis", settings.plot_axis);
  stored.setValue("hints/has_pushed", settings.has_pushed);
}

}  // namespace underact::gui
