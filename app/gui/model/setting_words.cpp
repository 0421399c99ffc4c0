#include "app/gui/model/setting_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/scene/settings.h"

namespace underact::gui {
namespace {

QString settingText(std::string_view path, const char* scene::Setting::*text) {
  const scene::Setting* const setting = scene::findSetting(path);
  return setting == nullptr ? QString() : QCoreApplication::translate("setting", setting->*text);
}

}  // namespace

QString settingLabel(std::string_view path) {
  return settingText(path, &scene::Setting::label);
}

QString settingTip(std::string_view path) {
  return settingText(path, &scene::Setting::tip);
}

QString settingUnit(std::string_view path) {
  const QString unit = settingText(path, &scene::Setting::unit);
  return unit == "us" ? QString::fromUtf8("µs")
                      : unit;  // as everywhere else in the window; files and commands are ASCII
}

double settingMax(std::string_view path) {
  const scene::Setting* const setting = scene::findSetting(path);
  return setting == nullptr ? 0.0 : setting->max;
}

QStringList settingChoices(std::string_view path) {
  const scene::Setting* const setting = scene::findSetting(path);
  if (setting == nullptr || setting->words == nullptr) return {};
  QStringList all;
  for (const std::string& word : setting->words()) {
    all << (setting->shown == nullptr ? QString::fromStdString(word)
                                      : QCoreApplication::translate("setting", setting->shown[all.size()]));
  }
  return all;
}

QString settingChoice(std::string_view path, std::string_view word) {
  const scene::Setting* const setting = scene::findSetting(path);
  if (setting == nullptr || setting->words == nullptr) return {};
  const std::vector<std::string> words = setting->words();
  return settingChoices(path).value(std::find(words.begin(), words.end(), word) - words.begin());
}

}  // namespace underact::gui
