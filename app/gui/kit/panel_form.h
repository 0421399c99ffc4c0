#pragma once

class QFormLayout;

namespace underact::gui {

/// A form layout for labels and choosers of a panel, one line each.
QFormLayout* panelForm();

}  // namespace underact::gui
