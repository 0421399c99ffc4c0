#include "tests/stories/lesson_steps.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>

#include "app/gui/window/features.h"
#include "core/lesson/window_names.h"
#include "device/simulated_arm.h"

namespace underact::gui::test {

QString stepTitle(Story& story) {
  return story.find<QLabel>("panel.lessons.step")->text();
}

void leadHand(Story& story, const Vec3& p_mm) {
  sim::HandSetpoint setpoint = story.arm().setpoint();
  setpoint.p_WT = 1e-3 * p_mm;
  story.arm().setSetpoint(setpoint);
  story.run(2000);
}

bool isPanelOpen(Story& story, const char* panel) {
  return !story.find<QDockWidget>(QString("dock.%1").arg(panel))->isHidden();
}

std::string shapeOf(Story& story) {
  QString shape = story.window().document().path();
  for (const PanelRow& row : panelsOf(features()))
    shape += isPanelOpen(story, row.key) ? QString(" %1").arg(row.key) : QString();
  for (const char* layer : lesson::layerNames()) {
    const QAction* const action = story.window().actions().find(QString("layer.%1").arg(layer));
    shape += action->isChecked() ? QString(" +%1").arg(layer) : QString();
  }
  return shape.toStdString();
}

}  // namespace underact::gui::test
