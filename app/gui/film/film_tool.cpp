#include "app/gui/film/film_tool.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMainWindow>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"

namespace underact::gui {

FilmTool::FilmTool(const FeatureParts& parts)
    : QObject(parts.window),
      actions_(parts.actions),
      document_(parts.document),
      player_(parts.player),
      window_(parts.window) {
  actions_.add({"view.film",
                tr("Film…"),
                {},
                tr("Saves a film of the scene, moved by a scripted hand, or of the open session.")},
               [this](const QVariantList& out) { return out.isEmpty() ? ask() : begin(out.first().toString()); });
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::readyRead, this, &FilmTool::read);
  connect(&process_, &QProcess::finished, this, &FilmTool::end);
}

FilmTool::~FilmTool() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();  // it removes what it has begun
  if (!process_.waitForFinished(3000)) process_.kill();
}

QString FilmTool::busyReason() const {
  return process_.state() == QProcess::NotRunning ? QString() : tr("A film is being made.");
}

bool FilmTool::ask() {
  const QString file = player_.isOpen() ? player_.path() : document_.path();
  askWhereToSave(window_, "dialog.film", tr("Save the film"), QFileInfo(file).completeBaseName() + ".webm",
                 tr("Films (*.webm *.mp4 *.gif)"), [this](const QString& path) { begin(path); });
  return true;
}

bool FilmTool::begin(const QString& out) {
  if (process_.state() != QProcess::NotRunning) return false;
  if (!player_.isOpen() && document_.modified()) {
    actions_.perform("notice.tell", tr("Save the scene first: a film shows the scene's file."));
    return false;
  }
  out_ = out;
  last_line_.clear();
  progress_ = new QProgressDialog(tr("Filming %1").arg(QFileInfo(out).fileName()), tr("Cancel"), 0, 100, window_);
  nameWidget(progress_, "dialog.filming", tr("Progress of the film"));
  progress_->setAttribute(Qt::WA_DeleteOnClose);
  progress_->setMinimumDuration(0);
  progress_->setAutoClose(false);
  progress_->show();
  connect(progress_, &QProgressDialog::canceled, &process_, &QProcess::terminate);
  process_.start(qEnvironmentVariable("UNDERACT_PROGRAM", QCoreApplication::applicationFilePath()),
                 {"--film", player_.isOpen() ? player_.path() : document_.path(), "--out", out, "--overwrite",
                  "--progress-lines"});
  return true;
}

void FilmTool::read() {
  while (process_.canReadLine()) {
    const QString line = QString::fromUtf8(process_.readLine()).trimmed();
    bool is_share = false;
    const int percent = line.toInt(&is_share);
    if (!is_share)
      last_line_ = line;
    else if (progress_ != nullptr)
      progress_->setValue(percent);
  }
}

void FilmTool::end(int code, QProcess::ExitStatus status) {
  read();
  const bool was_cancelled = progress_ == nullptr || progress_->wasCanceled();
  if (progress_ != nullptr) progress_->close();
  if (status == QProcess::NormalExit && code == 0) {
    actions_.perform("notice.tell", tr("Film saved as %1.").arg(QFileInfo(out_).fileName()), out_);
  } else if (!was_cancelled) {
    showProblemsBox("dialog.film_problems", tr("Film"), tr("The film was not made."), {{last_line_.toStdString(), {}}},
                    window_);
  }
}

}  // namespace underact::gui
