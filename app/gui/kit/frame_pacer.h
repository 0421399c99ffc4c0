#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace underact::gui {

/// Asks for frames: 60 a second where that leaves the window's thread idle for at least 40 % of the time, else fewer,
/// so that drawing never takes a whole core from the servo.
class FramePacer : public QObject {
  Q_OBJECT
 public:
  explicit FramePacer(QObject* parent = nullptr);
  void start();
  /// Not seen: 30 a second, enough to fetch what the servo says, and nothing is drawn.
  void setSeen(bool seen) { seen_ = seen; }
  bool isSeen() const { return seen_; }

 signals:
  void frame();

 private:
  void next();

  QTimer timer_;
  QElapsedTimer clock_;
  qint64 woke_ns_ = 0;  // when the thread last got something to do; 0: it waits
  qint64 busy_ns_ = 0;  // since the last frame
  double smooth_busy_ms_ = 0.0;
  int interval_ms_;
  bool seen_ = true;
};

}  // namespace underact::gui
