#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace underact::gui {

/// Requests frames: 60 a second if the window's thread is then idle for at least 40 % of the time, else fewer, so that
/// drawing never takes a whole core from the servo.
class FramePacer : public QObject {
  Q_OBJECT
 public:
  explicit FramePacer(QObject* parent = nullptr);
  void start();
  /// Hidden: 30 a second, enough to fetch the servo's data; nothing is drawn.
  void setSeen(bool seen) { seen_ = seen; }
  bool isSeen() const { return seen_; }

 signals:
  void frame();

 private:
  void next();

  QTimer timer_;
  QElapsedTimer clock_;
  qint64 woke_ns_ = 0;  // when the thread last woke up; 0: it is waiting
  qint64 busy_ns_ = 0;  // since the last frame
  double smooth_busy_ms_ = 0.0;
  int interval_ms_;
  bool seen_ = true;
};

}  // namespace underact::gui
