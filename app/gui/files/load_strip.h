#pragma once
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/kit/background.h"
#include "core/base/task_monitor.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace underact::gui {

/// Below the view while files are loaded in another thread: the file, the progress, and a button to cancel. The arm and
/// the window stay usable meanwhile.
class LoadStrip : public QWidget {
  Q_OBJECT
 public:
  /// Called in a thread of its own.
  using Work = std::function<void(const TaskMonitor& monitor)>;
  /// Called in the window's thread when the work is done; not if it was cancelled.
  using Done = std::function<void()>;

  explicit LoadStrip(QWidget* parent = nullptr);
  ~LoadStrip() override;
  /// what: "Loading bunny.stl". A load in progress is cancelled.
  void begin(const QString& what, Work work, Done done);
  void cancel();
  bool isBusy() const { return load_ != nullptr; }

 signals:
  void cancelled();

 private:
  struct Load;
  void poll();
  void show(const QString& step, double share);

  std::unique_ptr<Load> load_;
  std::vector<std::unique_ptr<Load>> leaving_;  // cancelled, not waited for
  QLabel* told_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer poll_timer_;
};

}  // namespace underact::gui
