#pragma once
#include <QWizard>
#include <span>
#include <utility>

namespace underact::gui {

/// Names a wizard's buttons for stories and screen readers, takes their pictures off, and makes it as large as its text
/// asks for and the window behind allows.
void frameWizard(QWizard& wizard, std::span<const std::pair<QWizard::WizardButton, const char*>> names, int wide_lines);

}  // namespace underact::gui
