#include "app/gui/model/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <clocale>

#include "app/gui/model/settings.h"

namespace underact::gui {
namespace {

constexpr const char* kLanguageKey = "window/language";
constexpr const char* kSystem = "system";
constexpr const char* kOwn = "underact.translator";

/// Installs the translator if its file exists.
void install(const QLocale& locale, const QString& name, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName(kOwn);
  if (translator->load(locale, name, QStringLiteral("_"), folder))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

}  // namespace

QStringList languages() {
  return {kSystem, "en", "de"};
}

QString chosenLanguage() {
  const QString chosen = QSettings().value(kLanguageKey, kSystem).toString();
  return languages().contains(chosen) ? chosen : kSystem;
}

void chooseLanguage(const QString& language) {
  if (!readSettings().are_newer) QSettings().setValue(kLanguageKey, language);
}

void speak(const QString& language) {
  qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(kOwn));  // each removes itself
  QLocale locale = language == kSystem ? QLocale::system() : QLocale(language);
  const QString first = locale.uiLanguages().value(0);  // texts and numbers may follow two countries
  if (QLocale(first).language() != QLocale::English) {  // the language of the sources
    // Qt's own texts first: translators installed later are asked first.
    install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(locale, QStringLiteral("underact"), QStringLiteral(":/languages"));
  }
  if (language == "en") locale = QLocale::c();
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale{};  // the next line takes over the options only once there is a default
  QLocale::setDefault(locale);
  std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's; scene files and VTK need decimal points
}

}  // namespace underact::gui
