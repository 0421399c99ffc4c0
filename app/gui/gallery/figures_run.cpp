#include "app/gui/gallery/figures_run.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QTimer>

#include "app/gui/gallery/figure_list.h"
#include "underact/version.h"
#ifdef Q_OS_UNIX
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#endif

namespace underact::gui {
namespace {

constexpr int kWaitForEnd_ms = 2000;
constexpr int kBehindTheWindow = 10;  // nice: the hand and its picture come first

}  // namespace

QString cliProgram() {
  if (qEnvironmentVariableIsSet("UNDERACT_CLI")) return qEnvironmentVariable("UNDERACT_CLI");
  return QCoreApplication::applicationDirPath() + "/underact-cli";
}

QString figureFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/figures";
}

FiguresRun::FiguresRun(const QString& folder, const QString& only, QObject* parent)
    : QObject(parent), folder_(folder), fresh_(folder + ".making"), only_(only), lock_(folder + ".lock") {
  lock_.setStaleLockTime(0);  // a run takes as long as it takes; what died left no process
  process_.setStandardOutputFile(QProcess::nullDevice());
#ifdef Q_OS_UNIX
  // A group of its own: the program starts others, which end with it.
  process_.setChildProcessModifier([] {
    ::setpgid(0, 0);
    ::setpriority(PRIO_PROCESS, 0, kBehindTheWindow);
  });
#endif
  connect(&process_, &QProcess::readyReadStandardError, this, &FiguresRun::read);
  connect(&process_, &QProcess::finished, this, &FiguresRun::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    lock_.unlock();
    emit finished(End::Failed,
                  tr("The program %1 could not be started. Install Underact whole.").arg(process_.program()));
  });
}

FiguresRun::~FiguresRun() {
  process_.disconnect(this);
  kill();
  if (lock_.isLocked()) QDir(fresh_).removeRecursively();
}

void FiguresRun::begin() {
  QDir().mkpath(QFileInfo(folder_).absolutePath());
  if (!lock_.tryLock()) {
    const bool other = lock_.error() == QLockFile::LockFailedError;
    emit finished(End::Failed,
                  other ? tr("Another window is making the figures. Wait until it has them, then open this anew.")
                        : tr("The folder %1 cannot be written.").arg(QFileInfo(folder_).absolutePath()));
    return;
  }
  QDir(fresh_).removeRecursively();
  QStringList words{"figures", "--out", fresh_, "--progress-lines"};
  if (!only_.isEmpty()) words << "--only" << only_;
  process_.start(cliProgram(), words, QIODevice::ReadOnly);
}

void FiguresRun::cancel() {
  cancelled_ = true;
  kill();
}

void FiguresRun::kill() {
  if (process_.state() == QProcess::NotRunning) return;
#ifdef Q_OS_UNIX
  process_.waitForStarted(kWaitForEnd_ms);  // before that it has no group yet
  if (process_.processId() > 0) ::kill(-static_cast<pid_t>(process_.processId()), SIGKILL);
#endif
  process_.kill();
  process_.waitForFinished(kWaitForEnd_ms);
}

void FiguresRun::read() {
  unread_ += process_.readAllStandardError();
  for (qsizetype end = unread_.indexOf('\n'); end >= 0; end = unread_.indexOf('\n')) {
    const QByteArray line = unread_.left(end).trimmed();
    unread_.remove(0, end + 1);
    const QJsonObject progress = QJsonDocument::fromJson(line).object();
    if (progress.contains("of"))
      emit progressed(progress["number"].toInt(), progress["of"].toInt(), progress["figure"].toString());
    else if (!line.isEmpty())
      last_words_ = QString::fromUtf8(line);
  }
}

void FiguresRun::end() {
  unread_ += '\n';
  read();
  const bool whole = process_.exitStatus() == QProcess::NormalExit && readFigures(fresh_);
  const QString why_not = cancelled_ ? tr("Cancelled: the figures are those from before.") : whole ? keep() : whyNot();
  QDir(fresh_).removeRecursively();
  lock_.unlock();
  emit finished(cancelled_ ? End::Cancelled : why_not.isEmpty() ? End::Made : End::Failed, why_not);
}

/// The new figures take the place of the old ones. Gives why not; empty: they do.
QString FiguresRun::keep() {
  const bool done = markFigures(fresh_, kVersion, QDateTime::currentDateTime()) && QDir(folder_).removeRecursively() &&
                    QDir().rename(fresh_, folder_);
  return done ? QString()
              : tr("The figures could not be put into %1. Make room there, or leave to write.").arg(folder_);
}

/// The last thing that it said: above it stands where it happened, which is for its makers.
QString FiguresRun::whyNot() const {
  return last_words_.isEmpty() ? tr("The figures were not made, and underact-cli did not say why.")
                               : tr("The figures were not made. %1").arg(last_words_);
}

}  // namespace underact::gui
