#pragma once
#include <QLabel>
#include <QMainWindow>
#include <QTemporaryDir>
#include <memory>

#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/simulated_host.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/window/docks.h"
#include "app/gui/window/services.h"

namespace underact::gui::test {

/// One feature, what its row makes, and nothing of any other: the services of a window, the simulated arm, time by
/// count. Not shown, unless a test asks for it.
class Desk {
 public:
  /// scene: the name of a shipped one, a path, or empty for none.
  explicit Desk(FeatureRow row, const QString& scene = "02_sphere", const Settings& settings = {});
  ~Desk();

  template <class... Argument>
  bool perform(const QString& name, const Argument&... arguments) {
    return services_->actions->perform(name, QVariantList{QVariant(arguments)...});
  }
  void open(const QString& scene);
  /// Ticks, with a frame now and then; not seconds.
  void run(int ticks);
  void frame();
  void show();
  /// A frame as the panels and followers get it, made up.
  void present(const servo::Snapshot& snapshot);
  /// The hand goes to p_WT (m) and the servo follows.
  void handTo(const Vec3& p_WT, int ticks = 500);

  /// The first widget of that object name in the window, or a window of its own; the test fails where there is none.
  template <class Widget = QWidget>
  Widget* find(const QString& name) {
    return qobject_cast<Widget*>(findWidget(name));
  }
  QString label(const QString& name);  // its text
  template <class Kind>
  Kind& panel() {
    return *dynamic_cast<Kind*>(docks_->panels().front());
  }
  template <class Kind>
  Kind& listener() {
    for (ServoListener* listener : listeners_)
      if (auto* found = dynamic_cast<Kind*>(listener)) return *found;
    std::abort();
  }
  const ServoListeners& listeners() const { return listeners_; }

  Document& document() { return *services_->document; }
  const scene::Description& scene() { return services_->document->scene(); }
  /// What the undo menu would take back: "stiffness x"; empty: nothing.
  QString undoText() { return services_->document->undoStack().undoText(); }
  Actions& actions() { return *services_->actions; }
  SceneView& view() { return *services_->view; }
  Services& services() { return *services_; }
  servo::Host& host() { return *simulated_.host; }
  device::SimulatedArm& arm() { return *simulated_.arm; }
  QMainWindow& window() { return *window_; }
  QString fileOf(const QString& name, const QByteArray& content) const;  // in a folder of its own

 private:
  QWidget* findWidget(const QString& name);

  SimulatedHost simulated_;
  QTemporaryDir folder_;
  ThemeWatcher theme_;
  Settings settings_;
  std::vector<HelpPage> pages_;
  std::unique_ptr<QMainWindow> window_;
  std::unique_ptr<Services> services_;
  std::unique_ptr<Docks> docks_;
  ServoListeners listeners_;
};

QString shippedScene(const QString& name);

}  // namespace underact::gui::test
