#include "tests/gui/desk.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QTest>
#include <algorithm>
#include <utility>

#include "app/gui/files/scene_files.h"
#include "app/gui/model/player.h"
#include "app/gui/view/hand.h"
#include "app/gui/view/view_actions.h"
#include "app/gui/window/window_actions.h"
#include "device/simulated_arm.h"

namespace underact::gui::test {

QString shippedScene(const QString& name) {
  return QString(UNDERACT_SOURCE) + "/scenes/" + name + ".json";
}

Desk::Desk(FeatureRow row, const QString& scene, const Settings& settings)
    : simulated_(makeSimulatedHost({.clock = servo::Clock::Manual})), settings_(settings), pages_(row.pages) {
  QSettings().clear();
  window_ = std::make_unique<QMainWindow>();
  window_->setObjectName("window");
  window_->resize(1280, 800);
  const WindowParts given{*simulated_.host, simulated_.arm, theme_, simulated_.replay, simulated_.chosen};
  services_ = std::make_unique<Services>(given, settings_, window_.get());
  const FeatureParts parts = services_->parts(given, settings_, pages_, [] { return QStringList(); });
  const std::vector<FeatureRow> rows{std::move(row)};
  addWindowActions(
      parts, rows, [] {}, [](const QString&) {});
  addViewActions(*services_->actions, *services_->view, theme_);
  if (rows.front().make != nullptr) rows.front().make(parts, listeners_);
  docks_ = std::make_unique<Docks>(rows, parts);
  listeners_.insert(listeners_.begin(), docks_->panels().begin(), docks_->panels().end());
  for (ServoListener* listener : listeners_) listener->setTheme(Theme::light());
  if (!scene.isEmpty()) open(scene);
  run(1);  // a servo always ticks: it knows where the stylus is
}

Desk::~Desk() {
  for (ServoListener* listener : listeners_) listener->finish();
  services_->document->undoStack().setClean();
  docks_.reset();
  window_.reset();
}

void Desk::open(const QString& scene) {
  document().undoStack().setClean();  // nobody is there to answer what becomes of edits
  const QString path = scene.contains('/') ? scene : shippedScene(scene);
  EXPECT_TRUE(services_->files->open(path));
  EXPECT_TRUE(QTest::qWaitFor([this] { return document().isOpen(); })) << "a scene with meshes opens later";
}

void Desk::frame() {
  services_->player->poll();
  for (ServoListener* listener : listeners_) listener->before();
  const servo::Snapshot snapshot = host().snapshot();
  host().drain([this](const servo::TickRecord& record) {
    services_->player->add(record);
    for (ServoListener* listener : listeners_) listener->add(record);
  });
  services_->hand->present(snapshot);
  present(snapshot);
}

void Desk::present(const servo::Snapshot& snapshot) {
  for (ServoListener* listener : listeners_) listener->present(snapshot);
  for (ServoListener* listener : listeners_) listener->poll(snapshot);
}

void Desk::run(int ticks) {
  constexpr int kTicksAFrame = 250;
  for (int done = 0; done < ticks; done += kTicksAFrame) {
    host().run(std::min(kTicksAFrame, ticks - done));
    frame();
  }
}

void Desk::handTo(const Vec3& p_WT, int ticks) {
  sim::HandSetpoint setpoint = arm().setpoint();
  setpoint.p_WT = p_WT;
  setpoint.holds = true;
  arm().setSetpoint(setpoint);
  run(ticks);
}

void Desk::show() {
  window_->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  for (Panel* panel : docks_->panels()) panel->bringForward();
  QTest::qWait(10);
  frame();
}

QWidget* Desk::findWidget(const QString& name) {
  if (auto* inside = window_->findChild<QWidget*>(name)) return inside;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (widget->objectName() == name) return widget;
  ADD_FAILURE() << "there is no " << name.toStdString();
  return nullptr;
}

QString Desk::label(const QString& name) {
  const auto* found = find<QLabel>(name);
  return found == nullptr ? QString() : found->text();
}

QString Desk::fileOf(const QString& name, const QByteArray& content) const {
  QFile file(folder_.filePath(name));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(content);
  return file.fileName();
}

}  // namespace underact::gui::test
