#include "app/gui/sessions/plots_run.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace underact::gui {
namespace {

constexpr int kWaitForEnd_ms = 2000;

/// Debian's, where there is one: it is the one that has Debian's libraries.
QString interpreter() {
  if (qEnvironmentVariableIsSet("UNDERACT_PYTHON")) return qEnvironmentVariable("UNDERACT_PYTHON");
  const QString debian = "/usr/bin/python3";
  return QFileInfo(debian).isExecutable() ? debian : QStringLiteral("python3");
}

/// "trial_*.pdf"
QString patternOf(const QString& out) {
  const QFileInfo file(out);
  return file.completeBaseName() + "_*." + file.suffix();
}

}  // namespace

QString pythonFolder() {
  const QString program = QCoreApplication::applicationDirPath();
  QStringList folders;
  if (qEnvironmentVariableIsSet("UNDERACT_DATA_DIR")) folders << qEnvironmentVariable("UNDERACT_DATA_DIR") + "/python";
  folders << program + "/../share/underact/python"
          << program + "/../../app/python";  // installed; run from build/release
  for (const QString& folder : folders) {
    if (QDir(folder + "/underact").exists()) return QDir(folder).absolutePath();
  }
  return {};
}

PlotsRun::PlotsRun(const QString& session, const QString& out, QObject* parent)
    : QObject(parent), session_(session), out_(out) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("PYTHONPATH", pythonFolder());
  process_.setProcessEnvironment(environment);
  process_.setStandardOutputFile(QProcess::nullDevice());
  connect(&process_, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
    if (cancelled_)
      emit finished(false, tr("Cancelled: the plots are not all drawn."));
    else if (status == QProcess::NormalExit && code == 0 && drawn() > 0)
      emit finished(true, tr("%1 plots are drawn: %2").arg(drawn()).arg(patternOf(out_)));
    else
      emit finished(false, whyNot());
  });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      emit finished(false, tr("Python could not be started. Install python3, python3-h5py and python3-matplotlib."));
  });
}

PlotsRun::~PlotsRun() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.kill();
  process_.waitForFinished(kWaitForEnd_ms);
}

void PlotsRun::begin() {
  if (pythonFolder().isEmpty()) {
    emit finished(
        false, tr("The Python package that draws plots was not found beside the program. Install the program whole."));
    return;
  }
  began_ = QDateTime::currentDateTime().addSecs(-1);  // some file systems keep whole seconds
  process_.start(interpreter(), {"-m", "underact", "plot", session_, "--kind", "all", "--out", out_});
}

void PlotsRun::cancel() {
  cancelled_ = true;
  process_.kill();
}

int PlotsRun::drawn() const {
  int files = 0;
  for (const QFileInfo& file : QFileInfo(out_).dir().entryInfoList({patternOf(out_)}, QDir::Files)) {
    if (file.lastModified() >= began_) ++files;
  }
  return files;
}

/// The last thing that it said: above it stands where it happened, which is for its makers.
QString PlotsRun::whyNot() {
  const QStringList lines = QString::fromUtf8(process_.readAllStandardError()).split('\n', Qt::SkipEmptyParts);
  return lines.isEmpty() ? tr("The plots were not drawn, and Python did not say why.")
                         : tr("The plots were not drawn. %1").arg(lines.last().trimmed());
}

}  // namespace underact::gui
