#include "app/gui/lessons/check_row.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QStyle>
#include <QVBoxLayout>
#include <optional>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/lessons/lesson_words.h"

namespace underact::gui {
namespace {

constexpr int kLettersOfNumber = 10;

}  // namespace

CheckRow::CheckRow(const lesson::Check& check, std::size_t number, QWidget* parent)
    : QWidget(parent),
      name_(QString("panel.lessons.check%1").arg(number)),
      message_(messageLabel(qPrintable(name_ + ".said"), tr("Check %1").arg(number), "", this)) {
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 4);
  column->setSpacing(4);
  if (const std::string* const question = lesson::questionOf(check)) {
    auto* const asked = messageLabel(qPrintable(name_ + ".question"), tr("Question %1").arg(number), "section", this);
    asked->setText(QString::fromStdString(*question));
    column->addWidget(asked);
  }
  if (const auto* const ask = std::get_if<lesson::AskNumber>(&check.task)) addNumber(*ask);
  if (const auto* const ask = std::get_if<lesson::AskChoice>(&check.task)) addChoices(*ask);
  column->addWidget(message_);
}

void CheckRow::addNumber(const lesson::AskNumber& ask) {
  const QString unit = QString::fromStdString(ask.unit);
  number_ = new QLineEdit(this);
  nameWidget(number_, name_ + ".number", tr("Answer to: %1").arg(QString::fromStdString(ask.question)),
             tr("Type a number and press Enter."));
  number_->setMaximumWidth(kLettersOfNumber * fontMetrics().averageCharWidth() + 24);
  auto* const line = new QHBoxLayout;
  line->setSpacing(8);
  line->addWidget(number_);
  line->addWidget(new QLabel(unit, this));
  QPushButton* const give = pushButton(name_ + ".give", tr("Check"), tr("Checks the answer."), this);
  line->addWidget(give);
  line->addStretch(1);
  static_cast<QVBoxLayout*>(layout())->addLayout(line);
  connect(number_, &QLineEdit::returnPressed, this, &CheckRow::give);
  connect(give, &QPushButton::clicked, this, &CheckRow::give);
}

void CheckRow::addChoices(const lesson::AskChoice& ask) {
  choices_ = new QButtonGroup(this);
  auto* const column = static_cast<QVBoxLayout*>(layout());
  for (std::size_t index = 0; index < ask.choices.size(); ++index) {
    const QString text = QString::fromStdString(ask.choices[index]);
    auto* const button = new QRadioButton(menuText(text), this);
    nameWidget(button, QString("%1.choice%2").arg(name_).arg(index + 1), text,
               tr("An answer to: %1").arg(QString::fromStdString(ask.question)));
    choices_->addButton(button, static_cast<int>(index) + 1);
    column->addWidget(button);
  }
  QPushButton* const give = pushButton(name_ + ".give", tr("Check"), tr("Checks the answer."), this);
  give->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  column->addWidget(give);
  connect(give, &QPushButton::clicked, this, &CheckRow::give);
}

void CheckRow::give() {
  if (choices_ != nullptr) {
    if (choices_->checkedId() > 0) emit answered(choices_->checkedId());
    return;
  }
  if (const std::optional<double> number = typed(number_->text())) {
    emit answered(*number);
  } else {
    message_->setText(tr("“%1” is not a number.").arg(number_->text()));
  }
}

void CheckRow::present(const lesson::Check& check, const lesson::CheckState& state) {
  const QString text = checkText(check, state);
  const bool shows_slip = number_ != nullptr && !state.solved && !number_->text().isEmpty() &&
                          !typed(number_->text());  // the message of give() stays
  if (message_->text() != text && !shows_slip) message_->setText(text);
  const char* const role = state.solved ? "running" : "";
  if (message_->property("role").toString() == role) return;
  message_->setProperty("role", role);
  message_->style()->unpolish(message_);
  message_->style()->polish(message_);
}

}  // namespace underact::gui
