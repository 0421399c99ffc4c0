#include "app/gui/projector/projector.h"

#include <QToolBar>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/larger_font.h"
#include "app/gui/kit/theme.h"
#include "app/gui/model/settings.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {

// The largest sizes at which the gauge does not reach into the scene in a window of 1280 x 800.
constexpr double kType = 1.6, kGauge = 2.0, kTools = 1.3;

Projector::Projector(Actions& actions, SceneView& view, ThemeWatcher& theme, QMainWindow* window)
    : QObject(window), window_(window), view_(view), theme_(theme), chrome_(window) {
  actions.add({"view.projector",
               tr("&Projector layout"),
               QKeySequence("Ctrl+Shift+J"),
               tr("For teaching: hides the panels and shows the view in high contrast with a large force gauge "
                  "and large text."),
               {},
               {},
               true},
              [this](const QVariantList& on) {
                setOn(on.value(0).toBool());
                return true;
              });
}

void Projector::remember(Settings& settings) {
  settings.projector = isOn();
  setOn(false);  // the normal layout is saved
}

void Projector::setOn(bool on) {
  if (on == isOn()) return;
  auto* tools = window_->findChild<QToolBar*>();
  if (on) {
    view_font_ = view_.font();
    tools_font_ = tools->font();
    icons_ = tools->iconSize();
    chrome_.hideChrome(WindowChrome::Keep::MenusAndTools);
  } else {
    chrome_.showChrome();
  }
  view_.setFont(on ? larger(view_font_, kType) : view_font_);
  view_.setGaugeScale(on ? kGauge : 1.0);
  tools->setFont(on ? larger(tools_font_, kTools) : tools_font_);
  tools->setIconSize(on ? kTools * icons_ : icons_);
  theme_.setHighContrast(on);
}

}  // namespace underact::gui
