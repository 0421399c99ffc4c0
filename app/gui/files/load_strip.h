#pragma once
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/kit/background.h"
#include "core/base/watch.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace underact::gui {

/// Below the view while meshes are loaded in another thread: what is loaded, how far it is, and a button to end it. The
/// arm, and everything in the window, goes on meanwhile.
class LoadStrip : public QWidget {
  Q_OBJECT
 public:
  /// In a thread of its own.
  using Work = std::function<void(const Watch& watch)>;
  /// In the window's thread, when the work has come to its end; not where it was cancelled.
  using Done = std::function<void()>;

  explicit LoadStrip(QWidget* parent = nullptr);
  ~LoadStrip() override;
  /// what: "Loading bunny.stl". A load that goes on is cancelled.
  void begin(const QString& what, Work work, Done done);
  void cancel();
  bool isBusy() const { return load_ != nullptr; }

 signals:
  void cancelled();

 private:
  struct Load;
  void look();
  void show(const QString& step, double share);

  std::unique_ptr<Load> load_;
  std::vector<std::unique_ptr<Load>> leaving_;  // cancelled: nobody waits for them
  QLabel* told_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer looks_;
};

}  // namespace underact::gui
