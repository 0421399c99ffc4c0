#pragma once
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/record/recorder.h"

namespace underact::gui {

/// The window's recording: its folder, its description and its state. All on the window's thread.
class Recording : public QObject {
  Q_OBJECT
 public:
  Recording(servo::Host& host, QObject* parent);
  ~Recording() override;

  /// Says what the servo does not know of a run that begins now, see record::RecorderOptions::run.
  void setRun(std::function<json::ObjectText()> run) { run_ = std::move(run); }
  /// The word of the running recording's session; empty: none is running.
  std::string sessionId() const { return recorder_ ? recorder_->sessionId() : std::string(); }
  /// Starts at once, into a new file in folder(). false: notice() says why not.
  bool start();
  /// Starts it, into a new file of that name.
  bool startAs(const QString& name);
  /// Ends it in order and writes the current description. false: none was running.
  bool stop(record::EndReason reason = record::EndReason::Stopped);
  /// false: nothing is being recorded.
  bool mark(const QString& label);

  bool isRunning() const { return recorder_ != nullptr; }
  /// Of the running recording, else of the last one.
  const record::RecorderStatus& status() const { return status_; }
  QString path() const { return path_; }
  int marks() const { return marks_; }
  /// Why it did not start, ended by itself, or is incomplete; empty: no problem.
  QString notice() const { return notice_; }

  /// The description of the running or the next recording. When a recording ends, name and notes are cleared; tags and
  /// subject are saved. Consent stays until the subject of the last recording changes, and is never saved in settings.
  const record::SessionMetadata& words() const { return words_; }
  void setWords(const record::SessionMetadata& words);
  /// The recording that the program was killed in, the last time it ran; empty: it ended in order.
  QString unfinished() const { return unfinished_; }
  void forgetUnfinished();
  QString folder() const { return folder_; }
  void setFolder(const QString& folder);

 signals:
  /// It started or ended, was marked, or its state was updated (four times a second).
  void changed();
  void ended(const QString& path);

 private:
  void startAt(const QString& path);
  void poll();
  void remember() const;

  servo::Host& host_;
  QTimer poll_timer_;
  std::unique_ptr<record::Recorder> recorder_;
  record::RecorderOptions options_;
  std::function<json::ObjectText()> run_;
  record::RecorderStatus status_;
  record::SessionMetadata words_, written_;      // the current ones; those in the file
  std::optional<std::string> recorded_subject_;  // the subject whose consent is still in words_
  QString unfinished_;
  QString folder_, path_, notice_;
  int marks_ = 0;
};

}  // namespace underact::gui
