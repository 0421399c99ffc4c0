#include "app/gui/feature/feature.h"

#include <QCoreApplication>
#include <QMainWindow>

#include "app/gui/arm/arm_panel.h"
#include "app/gui/arm/scene_arm_box.h"
#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/view/scene_view.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

Panel* makeArmPanel(const FeatureParts& parts, QWidget* parent) {
  auto* const panel = new ArmPanel(parent);
  auto* const box = new SceneArmBox(parts.document, parts.window, panel);
  panel->addAbove(box);
  const auto follow = [panel, document = &parts.document] { panel->setArm(scene::modelOf(document->scene())); };
  QObject::connect(&parts.document, &Document::opened, panel, follow);
  QObject::connect(&parts.document, &Document::edited, panel, follow);
  panel->showNotDrawn(parts.view.armProblems());
  const auto tell = [panel, actions = &parts.actions](const Problems& problems) {
    if (!panel->showNotDrawn(problems)) return;
    actions->perform("notice.tell", QObject::tr("Some meshes of the arm are not drawn. The panel Arm says why."), "");
  };
  QObject::connect(&parts.view, &SceneView::armRead, panel, tell);
  parts.actions.addCommand("scene.arm", [box, view = &parts.view](const QVariantList& arm) {
    if (!arm.isEmpty() && !box->take(arm.first().toString())) return false;
    if (arm.isEmpty())
      box->chooseFile();
    else
      view->moveCamera(Camera::Fit);
    return true;
  });
  return panel;
}

}  // namespace

FeatureRow armFeature() {
  return {.panels = {{"arm", QT_TRANSLATE_NOOP("panel", "Arm"), Qt::RightDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "The scene's arm: its joint angles, tip position and faults."),
                      makeArmPanel}},
          .pages = {{"panel.arm", "window#arm"},
                    {"dialog.scene_arm", "arm_files#in-a-scene"},
                    {"dialog.scene_arm_problems", "arm_files#in-a-scene"}},
          .opens = FileKind::Arm,
          .open_action = "scene.arm"};
}

}  // namespace underact::gui
