#include "app/gui/kit/restart.h"

#include <QCoreApplication>
#include <QProcess>

namespace underact::gui {

std::function<void()>& programStarter() {
  static std::function<void()> kStart = [] {
    QProcess::startDetached(QCoreApplication::applicationFilePath(), QCoreApplication::arguments().mid(1));
  };
  return kStart;
}

}  // namespace underact::gui
