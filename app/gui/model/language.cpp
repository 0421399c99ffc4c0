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

/// The translator joins the program where the file is there.
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
  qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(kOwn));  // each takes itself out
  QLocale locale = language == kSystem ? QLocale::system() : QLocale(language);
  const QString first = locale.uiLanguages().value(0);  // words and numbers may be of two countries
  if (QLocale(first).language() != QLocale::English) {  // which the sources speak
    // Qt's own words first: what is installed later is asked before.
    install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(locale, QStringLiteral("underact"), QStringLiteral(":/languages"));
  }
  if (language == "en") locale = QLocale::c();
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale{};  // only once there is a default does the next line take over the options
  QLocale::setDefault(locale);
  std::setlocale(LC_NUMERIC, "C");  // Qt has taken the user's; scene files and VTK read points
}

}  // namespace underact::gui
