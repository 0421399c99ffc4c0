#include "app/gui/sessions/plots_run.h"

#include <QDir>
#include <QFileInfo>

namespace underact::gui {
namespace {

/// "trial_*.pdf"
QString patternOf(const QString& out) {
  const QFileInfo file(out);
  return file.completeBaseName() + "_*." + file.suffix();
}

}  // namespace

PlotsRun::PlotsRun(const QString& session, const QString& out, QObject* parent)
    : QObject(parent), session_(session), out_(out) {
  connect(&process_, &CliProcess::ended, this, &PlotsRun::end);
}

void PlotsRun::begin() {
  began_ = QDateTime::currentDateTime().addSecs(-1);  // some file systems keep whole seconds
  process_.start({"log", "plot", session_, "--kind", "all", "--out", out_});
}

void PlotsRun::cancel() {
  cancelled_ = true;
  process_.kill();
}

void PlotsRun::end(std::optional<int> code) {
  if (cancelled_)
    emit finished(false, tr("Cancelled: not all plots were drawn."));
  else if (code == 0 && drawn() > 0)
    emit finished(true, tr("%1 plots saved: %2").arg(drawn()).arg(patternOf(out_)));
  else if (process_.lastLine().isEmpty())
    emit finished(false, tr("The plots were not drawn; underact-cli gave no reason."));
  else
    emit finished(false, tr("The plots were not drawn. %1").arg(process_.lastLine()));
}

int PlotsRun::drawn() const {
  int files = 0;
  for (const QFileInfo& file : QFileInfo(out_).dir().entryInfoList({patternOf(out_)}, QDir::Files)) {
    if (file.lastModified() >= began_) ++files;
  }
  return files;
}

}  // namespace underact::gui
