#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/frames/dh_panel.h"
#include "app/gui/frames/transform_panel.h"

namespace underact::gui {

FeatureRow framesFeature() {
  return {
      .panels = {{"dh", QT_TRANSLATE_NOOP("panel", "DH table"), Qt::LeftDockWidgetArea,
                  QT_TRANSLATE_NOOP("panel", "A DH table to edit, drawn beside the arm with the same joint angles."),
                  [](const FeatureParts& all, QWidget* parent) -> Panel* {
                    return new DhPanel({all.document, all.actions, all.view}, parent);
                  },
                  "scenes"},
                 {"transform", QT_TRANSLATE_NOOP("panel", "Transforms"), Qt::LeftDockWidgetArea,
                  QT_TRANSLATE_NOOP("panel", "Rotations and translations composed in both orders, side by side."),
                  [](const FeatureParts& all, QWidget* parent) -> Panel* {
                    return new TransformPanel({all.actions, all.view}, parent);
                  },
                  "scenes"}},
      .pages = {{"panel.dh", "kinematics#dh-table"}, {"panel.transform", "kinematics#transforms"}}};
}

}  // namespace underact::gui
