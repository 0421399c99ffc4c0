#include "app/gui/gallery/figures_run.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include "app/gui/gallery/figure_list.h"
#include "underact/version.h"

namespace underact::gui {

QString figureFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/figures";
}

FiguresRun::FiguresRun(const QString& folder, const QString& only, QObject* parent)
    : QObject(parent), folder_(folder), fresh_(folder + ".making"), only_(only), lock_(folder + ".lock") {
  lock_.setStaleLockTime(0);  // never stale by age: a run may take long, and a dead one has no process
  process_.setReader([this](const QByteArray& line) {
    const QJsonObject progress = QJsonDocument::fromJson(line).object();
    if (!progress.contains("of")) return false;
    emit progressed(progress["number"].toInt(), progress["of"].toInt(), progress["figure"].toString());
    return true;
  });
  connect(&process_, &CliProcess::ended, this, &FiguresRun::end);
}

FiguresRun::~FiguresRun() {
  process_.disconnect(this);
  process_.kill();
  if (lock_.isLocked()) QDir(fresh_).removeRecursively();
}

void FiguresRun::begin() {
  QDir().mkpath(QFileInfo(folder_).absolutePath());
  if (!lock_.tryLock()) {
    const bool other = lock_.error() == QLockFile::LockFailedError;
    emit finished(
        End::Failed,
        other ? tr("Another window is making the figures. Wait until it has finished, then open this window again.")
              : tr("The folder %1 is not writable. Change its permissions.").arg(QFileInfo(folder_).absolutePath()));
    return;
  }
  QDir(fresh_).removeRecursively();
  QStringList words{"figures", "--out", fresh_, "--progress-lines"};
  if (!only_.isEmpty()) words << "--only" << only_;
  process_.start(words);
}

void FiguresRun::cancel() {
  cancelled_ = true;
  process_.kill();
}

void FiguresRun::end(std::optional<int> code) {
  const bool whole = code && readFigures(fresh_);  // the code is not 0 when a number fails
  const QString refusal = cancelled_ ? tr("Cancelled. The earlier figures were kept.")
                          : whole    ? keep()
                                     : refusalReason();
  QDir(fresh_).removeRecursively();
  lock_.unlock();
  emit finished(cancelled_ ? End::Cancelled : refusal.isEmpty() ? End::Made : End::Failed, refusal);
}

/// Replaces the old figures by the new ones. Returns the error; empty: done.
QString FiguresRun::keep() {
  const bool done = markFigures(fresh_, kVersion, QDateTime::currentDateTime()) && QDir(folder_).removeRecursively() &&
                    QDir().rename(fresh_, folder_);
  return done ? QString()
              : tr("The figures could not be saved in %1. Free some space there or change its permissions.")
                    .arg(folder_);
}

QString FiguresRun::refusalReason() const {
  return process_.lastLine().isEmpty() ? tr("The figures were not made, and underact-cli gave no reason.")
                                       : tr("The figures were not made. %1").arg(process_.lastLine());
}

}  // namespace underact::gui
