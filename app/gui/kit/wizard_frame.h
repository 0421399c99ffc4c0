#pragma once
#include <QWizard>
#include <span>
#include <utility>

namespace underact::gui {

/// Names a wizard's buttons for stories and screen readers, removes their icons, and makes it as large as its text
/// needs and the window behind it allows.
void frameWizard(QWizard& wizard, std::span<const std::pair<QWizard::WizardButton, const char*>> names, int wide_lines);

}  // namespace underact::gui
