#pragma once
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "core/record/recorder.h"

namespace underact::gui {

/// The window's one recording: where it goes, what is said of it, how it is. All on the window's thread.
class Recording : public QObject {
  Q_OBJECT
 public:
  Recording(servo::Host& host, QObject* parent);
  ~Recording() override;

  /// Begins at once, into a new file of folder(). false: notice() says why.
  bool start();
  /// Ends it in order, and writes the words as they are now. false: none was running.
  bool stop(record::EndReason reason = record::EndReason::Stopped);
  /// false: nothing is recorded.
  bool mark(const QString& label);

  bool isRunning() const { return recorder_ != nullptr; }
  /// Of the one that runs, else of the last one.
  const record::RecorderStatus& status() const { return status_; }
  QString path() const { return path_; }
  int marks() const { return marks_; }
  /// Why it did not begin, ended by itself, or is not whole; empty: all is well.
  QString notice() const { return notice_; }

  /// Of the recording that runs, or of the next one. Its end forgets name and notes; tags and subject are
  /// remembered. Consent stays until the subject of the last recording is changed, and is not kept for another day.
  const record::SessionWords& words() const { return words_; }
  void setWords(const record::SessionWords& words);
  QString folder() const { return folder_; }
  void setFolder(const QString& folder);

 signals:
  /// It began or ended, was marked, or there is news of it (four times a second).
  void changed();
  void ended(const QString& path);

 private:
  void look();
  void remember() const;

  servo::Host& host_;
  QTimer looks_;
  std::unique_ptr<record::Recorder> recorder_;
  record::RecorderOptions options_;
  record::RecorderStatus status_;
  record::SessionWords words_, written_;         // as they are now; as they stand in the file
  std::optional<std::string> recorded_subject_;  // whose consent words_ still hold
  QString folder_, path_, notice_;
  int marks_ = 0;
};

}  // namespace underact::gui
