#include "app/gui/compare/two_views.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

TwoViews::TwoViews(SceneView& left, QWidget* parent) : QWidget(parent), left_(left) {
  setObjectName("compare.views");
  auto* row = tight<QHBoxLayout>(this, 1);
  const auto half = [&] {
    auto* made = new QWidget(this);
    tight<QVBoxLayout>(made, 0);
    row->addWidget(made, 1);
    return made;
  };
  auto* left_half = half();
  right_half_ = half();
  auto* const left_column = static_cast<QVBoxLayout*>(left_half->layout());
  left_head_ = head("compare.left", tr("Felt scene"), left_column);
  left_column->addWidget(&left_, 1);
  right_head_ = head("compare.right", tr("Other scene"), static_cast<QVBoxLayout*>(right_half_->layout()));
  left_head_->hide();
  right_half_->hide();
}

QLabel* TwoViews::head(const char* name, const QString& spoken, QVBoxLayout* column) {
  auto* made = new QLabel(this);
  nameWidget(made, name, spoken);
  made->setWordWrap(true);
  made->setMargin(6);
  column->addWidget(made);
  return made;
}

void TwoViews::makeRight() {
  right_ = new SceneView(right_half_);
  nameWidget(right_, "view.beside", tr("3D view of the other scene"));
  right_->setAccessibleDescription(
      tr("The scene that is not felt, with the same motion of the hand. The arrow keys rotate both views."));
  right_->setMinimumSize(left_.minimumSize());
  right_->setTheme(theme_);
  right_half_->layout()->addWidget(right_);
  static_cast<QVBoxLayout*>(right_half_->layout())->setStretchFactor(right_, 1);
  QWidget* last = &left_;
  for (QPushButton* button : left_.findChildren<QPushButton*>()) last = button;  // what lies over it belongs to it
  setTabOrder(last, right_);
}

bool TwoViews::showsRight() const {
  return !right_half_->isHidden();
}

void TwoViews::showRight(bool on) {
  if (on == showsRight()) return;
  if (on && right_ == nullptr) makeRight();
  if (on) {
    whole_ = left_.viewpoint();
    left_.setViewpoint({whole_.camera, true});  // half as wide, it would be cut
    follow();
  }
  left_head_->setVisible(on);
  right_half_->setVisible(on);
  if (!on && !whole_.fits && left_.viewpoint().fits)
    left_.setViewpoint(whole_);  // as it was, if nobody turned it since
}

void TwoViews::setHeads(const QString& left, const QString& right) {
  left_head_->setText(left);
  right_head_->setText(right);
}

void TwoViews::setTheme(const Theme& theme) {
  theme_ = theme;
  if (right_ != nullptr) right_->setTheme(theme);
}

/// The right view takes over camera and layers of the left one.
void TwoViews::follow() {
  if (!(right_->layers() == left_.layers())) right_->setLayers(left_.layers());
  seen_ = {left_.viewpoint().camera, false};
  right_->setViewpoint(seen_);
}

/// A longer head takes more lines: with both of the same height both views have the same size, and thus the same scale.
void TwoViews::levelHeads() {
  int high = 0;
  for (const QLabel* head : {left_head_, right_head_})
    high = std::max(high, head->hasHeightForWidth() ? head->heightForWidth(head->width()) : head->sizeHint().height());
  for (QLabel* head : {left_head_, right_head_}) {
    if (head->height() != high || head->minimumHeight() != high) head->setFixedHeight(high);
  }
}

void TwoViews::present() {
  if (!showsRight()) return;
  const OrbitCamera there = right_->viewpoint().camera;
  if (!(there == seen_.camera)) {  // the user moved it
    seen_ = {there, false};
    left_.setViewpoint(seen_);
  }
  if (!(left_.viewpoint().camera == seen_.camera) || !(right_->layers() == left_.layers())) follow();
  levelHeads();
  if (right_->gaugeScale() != left_.gaugeScale()) right_->setGaugeScale(left_.gaugeScale());
  for (QWidget* widget : QList<QWidget*>{right_, left_head_, right_head_}) {
    if (widget->font() != left_.font()) widget->setFont(left_.font());
  }
}

}  // namespace underact::gui
