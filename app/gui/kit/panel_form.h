#pragma once

class QFormLayout;

namespace underact::gui {

/// Labels and choosers of a panel, one line each.
QFormLayout* panelForm();

}  // namespace underact::gui
