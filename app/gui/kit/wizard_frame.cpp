#include "app/gui/kit/wizard_frame.h"

#include <QAbstractButton>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/stop_key.h"

namespace underact::gui {

void frameWizard(QWizard& wizard, std::span<const std::pair<QWizard::WizardButton, const char*>> names,
                 int wide_lines) {
  for (const auto& [which, name] : names) {
    QAbstractButton* const button = wizard.button(which);
    nameWidget(button, name, wizard.buttonText(which).remove('&').remove('<').remove('>').trimmed());
    button->setIcon({});
  }
  wizard.setProperty(StopKey::kEscStops, true);
  constexpr int kHighLines = 46;
  const int line = wizard.fontMetrics().lineSpacing();
  const QWidget* const behind = wizard.parentWidget();
  const QSize most = behind != nullptr ? behind->size() : QSize(1280, 800);  // large text on a small screen
  wizard.resize(QSize(wide_lines * line, kHighLines * line).boundedTo(most));
}

}  // namespace underact::gui
