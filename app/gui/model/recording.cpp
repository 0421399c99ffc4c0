#include "app/gui/model/recording.h"

#include <QSettings>
#include <algorithm>

#include "app/gui/kit/words.h"
#include "app/gui/model/session_paths.h"

namespace underact::gui {
namespace {

constexpr int kPollRoom_ms = 250;
constexpr qint64 kMegabyte = 1'000'000;
constexpr const char* kFolder = "recording/folder";
constexpr const char* kUnfinished = "recording/unfinished";
constexpr const char* kTags = "recording/tags";
constexpr const char* kSubject = "recording/subject";
constexpr const char* kKeepFree = "recording/keep_free_MB";  // on the disk; below this a recording ends in order

}  // namespace

Recording::Recording(servo::Host& host, QObject* parent) : QObject(parent), host_(host) {
  const QSettings stored;
  folder_ = stored.value(kFolder, defaultSessionFolder()).toString();
  unfinished_ = stored.value(kUnfinished).toString();
  words_.tags = stored.value(kTags).toString().toStdString();
  words_.subject = stored.value(kSubject).toString().toStdString();
  if (stored.contains(kKeepFree))
    options_.reserve_bytes = std::max<qint64>(0, stored.value(kKeepFree).toLongLong()) * kMegabyte;
  poll_timer_.setInterval(kPollRoom_ms);
  connect(&poll_timer_, &QTimer::timeout, this, &Recording::poll);
}

Recording::~Recording() {
  const QSignalBlocker silent(this);  // listeners may be destroyed already
  stop(record::EndReason::ProgramEnded);
}

bool Recording::start() {
  if (isRunning()) return false;
  startAt(newSessionFile(folder_, QDateTime::currentDateTime(), QString::fromStdString(host_.scene().title)));
  return isRunning();
}

bool Recording::startAs(const QString& name) {
  if (isRunning()) return false;
  startAt(folder_ + '/' + name);
  return isRunning();
}

void Recording::startAt(const QString& path) {
  notice_ = prepareSessionFolder(folder_);
  if (notice_.isEmpty()) {
    if (run_) options_.run = run_();
    Result<std::unique_ptr<record::Recorder>> recorder =
        record::Recorder::start(host_, path.toStdString(), words_, options_);
    if (recorder) {
      recorder_ = std::move(recorder).value();
      path_ = path;
      written_ = words_;
      status_ = {};
      marks_ = 0;
      poll_timer_.start();
      QSettings().setValue(kUnfinished, path);
    } else {
      notice_ = tr("%1 Choose another folder for the recordings.").arg(sentencesOf(recorder.problems()));
    }
  }
  emit changed();
}

bool Recording::stop(record::EndReason reason) {
  if (!isRunning()) return false;
  poll_timer_.stop();
  Problems problems = recorder_->stop(reason);
  status_ = recorder_->status();
  recorder_.reset();
  QSettings().remove(kUnfinished);
  if (words_ != written_) {
    Problems unwritten;
    for (const std::string& file : status_.files) {
      const Problems of_part = record::rewriteMetadata(file, words_);
      unwritten.insert(unwritten.end(), of_part.begin(), of_part.end());
    }
    if (!unwritten.empty() && problems.empty())
      problems.push_back({phrase(QT_TRANSLATE_NOOP(
          "problem", "Text typed during the recording is not in the file. Edit the details of the session below."))});
  }
  words_.name.clear();  // they belonged to this recording
  words_.notes.clear();
  recorded_subject_ = words_.subject;
  remember();
  notice_ = sentencesOf(problems);
  emit changed();
  emit ended(path_);
  return true;
}

bool Recording::mark(const QString& label) {
  if (!isRunning()) return false;
  recorder_->mark(label.trimmed().toStdString());
  ++marks_;
  emit changed();
  return true;
}

void Recording::poll() {
  status_ = recorder_->status();
  recorder_->noteServo();
  if (status_.recording)
    emit changed();
  else
    stop();
}

void Recording::setWords(const record::SessionMetadata& words) {
  const bool is_another = recorded_subject_ && words.subject != *recorded_subject_;
  const bool is_carried = words.consent == words_.consent;
  words_ = words;
  if (is_another) {
    recorded_subject_.reset();
    if (is_carried) words_.consent.clear();  // one person's consent is not the next one's
  }
  remember();
}

void Recording::forgetUnfinished() {
  unfinished_.clear();
  QSettings().remove(kUnfinished);
}

void Recording::setFolder(const QString& folder) {
  folder_ = folder;
  notice_.clear();
  QSettings().setValue(kFolder, folder);
  emit changed();
}

void Recording::remember() const {
  QSettings stored;
  stored.setValue(kTags, QString::fromStdString(words_.tags));
  stored.setValue(kSubject, QString::fromStdString(words_.subject));
}

}  // namespace underact::gui
