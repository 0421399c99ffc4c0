#include "app/gui/model/setting_words.h"

#include <QCoreApplication>

#include "core/scene/settings.h"

namespace underact::gui {

QString settingLabel(std::string_view path) {
  const scene::Setting* const setting = scene::findSetting(path);
  return setting == nullptr ? QString() : QCoreApplication::translate("setting", setting->label);
}

QString settingTip(std::string_view path) {
  const scene::Setting* const setting = scene::findSetting(path);
  return setting == nullptr ? QString() : QCoreApplication::translate("setting", setting->tip);
}

double settingMost(std::string_view path) {
  const scene::Setting* const setting = scene::findSetting(path);
  return setting == nullptr ? 0.0 : setting->most;
}

}  // namespace underact::gui
