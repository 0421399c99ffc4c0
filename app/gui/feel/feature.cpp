#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/feel/feel_panel.h"

namespace underact::gui {

FeatureRow feelFeature() {
  return {.panels = {{"feel", QT_TRANSLATE_NOOP("panel", "Feel"), Qt::RightDockWidgetArea,
                      QT_TRANSLATE_NOOP("panel", "How hard the constraint pulls, axis by axis."),
                      [](const FeatureParts& all, QWidget* parent) -> Panel* {
                        return new FeelPanel({all.servo, all.document, all.actions, all.rate}, parent);
                      }}},
          .pages = {{"panel.feel", "window#feel"},
                    {"panel.gains", "window#feel"},
                    {"panel.influence", "scenes#influence"},
                    {"panel.rate", "velocity"},
                    {"panel.rate.passivity", "energy"},
                    {"panel.surface", "meshes"},
                    {"panel.surface.friction", "scenes#friction"},
                    {"panel.guide", "curves"}}};
}

}  // namespace underact::gui
