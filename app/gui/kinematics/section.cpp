#include "app/gui/kinematics/section.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace underact::gui {

Section::Section(const QString& key, const QString& title, const QString& tip, QWidget* parent, const QString& panel)
    : QWidget(parent), content_(new QWidget(this)), column_(new QVBoxLayout(content_)) {
  auto* fold = new QToolButton(this);
  fold->setObjectName(QString("panel.%1.%2.fold").arg(panel, key));
  fold->setAccessibleName(tr("%1, show or hide").arg(title));
  fold->setToolTip(tip);
  fold->setText(title);
  fold->setProperty("role", "fold");
  fold->setCheckable(true);
  fold->setChecked(true);
  fold->setArrowType(Qt::DownArrow);
  fold->setAutoRaise(true);
  fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold->setFocusPolicy(Qt::StrongFocus);
  fold->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(fold, &QToolButton::toggled, this, [this, fold](bool open) {
    fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    content_->setVisible(open);
  });
  column_->setContentsMargins(4, 0, 0, 4);
  column_->setSpacing(4);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(4);
  outer->addWidget(fold);
  outer->addWidget(content_);
}

}  // namespace underact::gui
