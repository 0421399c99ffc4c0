#include "app/gui/visitor/title_card.h"

#include <QAccessible>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"

namespace underact::gui {
namespace {

constexpr int kSmallest_px = 15;
constexpr double kShare = 0.27;  // of the screen: the title, two lines of what to feel, two of what to try

void setType(QWidget* widget, double px, bool bold = false) {
  QFont font = widget->font();
  font.setPixelSize(qMax(kSmallest_px, qRound(px)));
  font.setBold(bold);
  widget->setFont(font);
}

}  // namespace

TitleCard::TitleCard(QWidget* parent)
    : QFrame(parent),
      title_(messageLabel("visitor.title", tr("Scene"), "", this)),
      feel_(messageLabel("visitor.feel", tr("What to feel"), "", this)),
      try_(messageLabel("visitor.try", tr("What to try"), "", this)),
      trouble_(messageLabel("visitor.trouble", tr("Problem"), "alarm", this)),
      leaving_(messageLabel("visitor.way_out", tr("How to leave"), "quiet", this)),
      next_(pushButton("visitor.next", tr("Next"), tr("Shows the next scene."), this)),
      start_(pushButton("visitor.go", tr("Start"), tr("Turns the force on. Esc turns it off."), this)) {
  setObjectName("visitor");
  setAccessibleName(tr("About the scene"));
  hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(32, 20, 32, 24);
  grid->setHorizontalSpacing(32);
  grid->setVerticalSpacing(8);
  grid->addWidget(title_, 0, 0);
  grid->addWidget(feel_, 1, 0);
  grid->addWidget(try_, 2, 0);
  grid->addWidget(trouble_, 3, 0);
  grid->addWidget(leaving_, 4, 0, 1, 2);
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(start_);
  buttons->addStretch();
  buttons->addWidget(next_);
  grid->addLayout(buttons, 0, 1, 4, 1);
  grid->setColumnStretch(0, 1);
  for (QWidget* passing : {static_cast<QWidget*>(leaving_), static_cast<QWidget*>(start_)}) {
    QSizePolicy policy = passing->sizePolicy();
    policy.setRetainSizeWhenHidden(true);  // so that Next stays where a hand reaches for it
    passing->setSizePolicy(policy);
  }
  leaving_->setText(tr("For demonstrators: Ctrl+Alt+Shift+U opens a panel with Stop and Leave visitor mode."));
  leaving_->hide();
  for (QLabel* label : {title_, feel_, try_, trouble_, leaving_}) label->setTextInteractionFlags(Qt::NoTextInteraction);
  connect(next_, &QPushButton::clicked, this, &TitleCard::nextAsked);
  connect(start_, &QPushButton::clicked, this, &TitleCard::startAsked);
  setState(false, {});
}

void TitleCard::setScene(const QString& title, const QString& feel, const QString& try_this) {
  title_->setText(title);
  feel_->setText(feel);
  try_->setText(try_this);
  QAccessibleEvent alert(title_, QAccessible::Alert);
  if (isVisible()) QAccessible::updateAccessibility(&alert);
}

void TitleCard::setState(bool can_start, const QString& trouble) {
  start_->setVisible(can_start);
  showMessage(trouble_, trouble);
  try_->setVisible(trouble.isEmpty());  // the problem is shown instead
}

void TitleCard::showWayOut(bool on) {
  leaving_->setVisible(on);
}

void TitleCard::fitInto(int height_px) {
  setType(title_, height_px / 24.0, true);
  for (QWidget* words : {static_cast<QWidget*>(feel_), static_cast<QWidget*>(try_), static_cast<QWidget*>(trouble_)})
    setType(words, height_px / 38.0);
  setType(leaving_, height_px / 50.0);
  const int side = height_px / 24, above = height_px / 40;
  layout()->setContentsMargins(side, above, side, above);
  setType(next_, height_px / 30.0);
  setType(start_, height_px / 20.0, true);
  // Independent of its text, so that the view above keeps its size and does not jump or render again.
  setFixedHeight(qRound(kShare * height_px));
}

}  // namespace underact::gui
