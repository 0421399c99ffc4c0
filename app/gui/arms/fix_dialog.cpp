#include "app/gui/arms/fix_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

QWidget* commandField(const QString& name, const QString& command, QWidget* parent) {
  auto* field = new QPlainTextEdit(command, parent);
  nameWidget(field, name, FixDialog::tr("Command for a terminal"));
  field->setReadOnly(true);
  field->setTabChangesFocus(true);
  field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  const int columns = qMax(1, field->fontMetrics().horizontalAdvance(command) / (30 * parent->fontMetrics().height()));
  field->setFixedHeight((columns + 2) * field->fontMetrics().lineSpacing());
  return field;
}

}  // namespace

FixDialog::FixDialog(const QString& arm, const std::vector<device::Missing>& missing, QWidget* parent)
    : QDialog(parent) {
  setObjectName("dialog.fix");
  setWindowTitle(tr("How to use this arm"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(34 * fontMetrics().height());
  auto* column = new QVBoxLayout(this);
  column->setSpacing(8);
  column->addWidget(sectionTitle(arm, this));
  int number = 0;
  for (const device::Missing& one : missing) {
    const QString name = QString("dialog.fix.%1").arg(number++), command = QString::fromStdString(one.command);
    QLabel* sentence = messageLabel(name.toLatin1().constData(), tr("What is missing"), "", this);
    sentence->setText(sentenceText(one.sentence));
    column->addWidget(sentence);
    if (command.isEmpty()) continue;
    column->addWidget(commandField(name + ".command", command, this));
    QPushButton* copy =
        pushButton(name + ".copy", tr("Copy the command"), tr("Copies the command; paste it into a terminal."), this);
    connect(copy, &QPushButton::clicked, this, [command] { QApplication::clipboard()->setText(command); });
    column->addWidget(copy, 0, Qt::AlignLeft);
  }
  column->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Close)->setObjectName("dialog.fix.close");
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

}  // namespace underact::gui
