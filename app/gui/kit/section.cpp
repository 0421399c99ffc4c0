#include "app/gui/kit/section.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

Section::Section(const QString& key, const QString& title, const QString& tip, QWidget* parent, const QString& panel)
    : QWidget(parent), fold_(new QToolButton(this)), content_(new QWidget(this)), column_(new QVBoxLayout(content_)) {
  nameWidget(fold_, QString("panel.%1.%2.fold").arg(panel, key), tr("%1, show or hide").arg(title), tip);
  fold_->setText(title);
  fold_->setProperty("role", "fold");
  fold_->setCheckable(true);
  fold_->setChecked(true);
  fold_->setArrowType(Qt::DownArrow);
  fold_->setAutoRaise(true);
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setFocusPolicy(Qt::StrongFocus);
  fold_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(fold_, &QToolButton::toggled, this, [this](bool open) {
    fold_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    content_->setVisible(open);
  });
  column_->setContentsMargins(4, 0, 0, 4);
  column_->setSpacing(4);
  auto* outer = tight<QVBoxLayout>(this, 4);
  outer->addWidget(fold_);
  outer->addWidget(content_);
}

void Section::setOpen(bool open) {
  fold_->setChecked(open);
}

}  // namespace underact::gui
