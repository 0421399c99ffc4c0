#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/kinematics/kinematics_panel.h"

namespace underact::gui {

FeatureRow kinematicsFeature() {
  return {.panels = {{"kinematics", QT_TRANSLATE_NOOP("panel", "Kinematics"), Qt::LeftDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "Joints, DH table, inverse solutions, Jacobian and singularities."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new KinematicsPanel({all.document, all.actions, all.view, all.player, all.arms}, parent);
                      },
                      "scenes"}},
          .pages = {{"panel.kinematics", "kinematics#in-the-window"},
                    {"panel.kinematics.joint", "kinematics#moving-the-joints"},
                    {"panel.kinematics.singularity", "kinematics#distance-to-singularities"},
                    {"panel.kinematics.solutions", "kinematics#inverse-solutions"},
                    {"panel.kinematics.dh", "kinematics#dh-table-and-angle-conventions"},
                    {"panel.kinematics.jacobian", "kinematics#jacobian-and-ellipsoids"},
                    {"view.kinematics", "kinematics#in-the-window"}}};
}

}  // namespace underact::gui
