#include "app/gui/view/hand_actions.h"

#include <QAction>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/words.h"
#include "app/gui/view/hand.h"

namespace underact::gui {

void addHandActions(Actions& actions, Hand& hand, bool keeps_holding) {
  actions.add({"hand.keep", tr("&Keep holding"), QKeySequence("F6"),
               tr("The simulated hand keeps holding the stylus when you release the mouse; otherwise it lets go."),
               "hold", tr("Keep holding"), true},
              [&hand](const QVariantList& on) {
                hand.setKeepsHolding(on.value(0).toBool());
                return true;
              });
  actions.add({"hand.let_go", tr("Let go of the st&ylus"), QKeySequence("Shift+F6"),
               tr("The simulated hand lets go: the stylus goes where the scene sends it.")},
              [&actions, &hand](const QVariantList&) {
                if (hand.keepsHolding()) return actions.perform("hand.keep", false);
                hand.letGo();
                return true;
              });
  if (keeps_holding) actions.perform("hand.keep", true);
}

}  // namespace underact::gui
