#pragma once
#include <QImage>
#include <QPointer>
#include <QTest>
#include <QVariantList>
#include <memory>
#include <vector>

#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/window/main_window.h"

namespace underact::gui::test {

inline constexpr int kLong_ms = 20'000;  // that a slow machine may take

/// What a story starts with.
struct Beginning {
  QSize size{1280, 800};
  bool first_start = true;  // nothing is remembered from an earlier life of the window
  bool shown = true;
  bool keeps_holding = true;                                 // the hand stays where the story puts it; a user's lets go
  std::vector<device::input::DeviceEnumerator*> hands = {};  // controllers and 3D mice; they outlive the story
  servo::HostOptions servo{.clock = servo::Clock::Manual};   // time by count: the machine's speed decides nothing
  std::vector<FeatureRow> features = gui::features();
  double busy_limit_s = 0.0;  // see WindowParts
};

/// The real window on a simulated arm. It acts through real events and by the names of actions, then looks.
class Story {
 public:
  /// scene: the name of a shipped scene ("02_sphere"), a path, or empty for none.
  explicit Story(const QString& scene, const Beginning& beginning = {});
  ~Story();

  template <class... Argument>
  bool perform(const QString& name, const Argument&... arguments) {
    return window_->actions().perform(name, QVariantList{QVariant(arguments)...});
  }
  /// Ticks, with a frame now and then and, more seldom, a paint; not seconds.
  void run(int ticks);
  servo::Snapshot snapshot() { return simulated_.host->snapshot(); }
  double force_N() { return snapshot().report.force.f_T_W().norm(); }

  MainWindow& window() { return *window_; }
  SceneView& view() { return window_->view(); }
  servo::Host& host() { return *simulated_.host; }
  device::SimulatedArm& arm() { return *simulated_.arm; }
  /// The widget of that object name; the test fails where there is none.
  template <class Widget = QWidget>
  Widget* find(const QString& name) {
    return qobject_cast<Widget*>(findWidget(name));
  }

  // Mouse and keys as the window system sends them: to the window, which hands them on to what is there. What they
  // change is painted when the window next waits for something.
  void press(QWidget* at, const QPoint& where);
  void moveTo(QWidget* at, const QPoint& where);
  void release(QWidget* at, const QPoint& where);
  void click(QWidget* at, const QPoint& where);
  void click(QWidget* at) { click(at, at->rect().center()); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  void byPalette(const QString& words);             // what these letters find first is done
  void bringToFront(QWidget* window);               // with the keyboard: there is no window manager to do it
  void type(QWidget* number, const QString& text);  // over what is there, then Enter
  /// The stylus from where it is to p_W (m), in steps, with ticks in between; the button stays down with hold.
  void dragHandTo(const Vec3& p_W, bool hold = false);
  void settle(int ms = 60);  // lets the window catch up, and the camera arrive

  /// The window as it is on the screen.
  QImage picture();
  void savePicture(const QString& name);
  /// The view against tests/stories/reference/NAME.png: the largest difference of a 16 x 16 block's mean, 0 to 1. A
  /// mean over the whole picture would miss a stylus. UNDERACT_UPDATE_PICTURES=1 writes the reference anew.
  double imageDifference(const QString& name);

 private:
  void open(const QString& scene, const Beginning& beginning);
  QWidget* findWidget(const QString& name);

  SimulatedHost simulated_;
  std::unique_ptr<ThemeWatcher> theme_;
  std::unique_ptr<MainWindow> window_;
  int unpainted_ticks_ = 0;
};

QString shippedScene(const QString& name);
QString temporaryFile(const QString& name, const QByteArray& content = {});
void forgetSettings();

}  // namespace underact::gui::test
