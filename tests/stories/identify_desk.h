#pragma once
#include <QAbstractButton>
#include <QLabel>
#include <QTableWidget>
#include <atomic>

#include "app/gui/identify/identify_tool.h"
#include "app/gui/identify/identify_wizard.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

// What stories about the measurement of the arm share.

/// Where they are waited for, never measured: the machine may be busy.
inline constexpr int kFitsTake_ms = 120'000;
inline constexpr int kMaxTicks = 60'000;  // of the arm at 1 kHz; a measurement takes 34,000

/// The wizard in a window whose servo ticks by count.
class Wizard {
 public:
  using State = IdentifyRun::State;
  /// Opens it on its first page. tick: so many ticks with a frame behind them.
  Wizard(MainWindow& window, std::function<void(int ticks)> tick);
  QWizard* dialog() { return window_.findChild<IdentifyWizard*>(); }
  const IdentifyRun& run() { return window_.findChild<IdentifyTool*>()->run(); }
  State state() { return run().state(); }
  template <class Widget = QAbstractButton>
  Widget* in(const QString& name) {
    return qobject_cast<Widget*>(widget(name));
  }
  QString text(const QString& label) { return in<QLabel>(label)->text(); }
  bool shows(const QString& name) { return widget(name)->isVisible(); }
  void press(const QString& name);
  /// To the page that measures.
  void begin();
  /// Ticks until all is recorded; presses "Continue" where it is asked to. false: it stopped, or does not come to an
  /// end.
  bool record();
  /// Frames, without a tick, until it is so.
  template <class Condition>
  bool comes(const Condition& condition) {
    return QTest::qWaitFor(
        [&] {
          window_.frame();
          return condition();
        },
        kFitsTake_ms);
  }
  /// All of it.
  void measure();
  /// What it looks like, into the build's pictures.
  void keepPicture(const QString& name);

 private:
  QWidget* widget(const QString& name);
  MainWindow& window_;
  std::function<void(int)> tick_;
};

/// The window with the sphere and the wizard.
struct IdentifyDesk : Story {
  explicit IdentifyDesk(const Beginning& beginning = {}, bool servo_runs = true);
  Document& document() { return window().document(); }
  Wizard wizard;
};

/// A window on an arm that is none of its simulated ones: its cable can be pulled, and its hand has let go.
struct IdentifyOnCable {
  IdentifyOnCable();
  ~IdentifyOnCable();
  void run(int ticks);
  std::atomic<bool> plugged_in{true};
  servo::Host host;
  ThemeWatcher theme;
  MainWindow window;
  std::unique_ptr<Wizard> wizard;
};

QString cell(const QTableWidget* table, const QString& quantity, int column);
/// Within 5 %.
void expectNear(const QTableWidget* table, const QString& quantity, double given);

}  // namespace underact::gui::test
