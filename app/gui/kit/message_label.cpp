#include "app/gui/kit/message_label.h"

#include <QLabel>

namespace underact::gui {

void nameWidget(QWidget* widget, const QString& name, const QString& spoken, const QString& tip) {
  widget->setObjectName(name);
  widget->setAccessibleName(spoken);
  if (!tip.isEmpty()) widget->setToolTip(tip);
}

QLabel* messageLabel(const char* name, const QString& spoken, const char* role, QWidget* parent) {
  auto* label = new QLabel(parent);
  nameWidget(label, name, spoken);
  label->setProperty("role", role);
  label->setIndent(0);  // a role with a border would be indented by half a letter
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

void updateText(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

void showMessage(QLabel* label, const QString& text) {
  updateText(label, text);
  label->setVisible(!text.isEmpty());
}

QLabel* sectionTitle(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "section");
  label->setIndent(0);
  return label;
}

}  // namespace underact::gui
