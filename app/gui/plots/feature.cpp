#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/plots/plots_panel.h"

namespace underact::gui {

FeatureRow plotsFeature() {
  return {
      .panels = {{"plots", QT_TRANSLATE_NOOP("panel", "Plots"), Qt::BottomDockWidgetArea,
                  QT_TRANSLATE_NOOP(
                      "panel", "Error and force over the last 10 s, and force against displacement along one axis."),
                  [](const FeatureParts& all, QWidget* parent) -> Panel* {
                    return new PlotsPanel({all.document, all.actions, all.player, all.settings}, parent);
                  }}},
      .pages = {{"panel.plots", "window#plots"}, {"dialog.save_plot", "window#plots"}}};
}

}  // namespace underact::gui
