#include "app/gui/feel/feel_foot.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"

namespace underact::gui {

FeelFoot::FeelFoot(Actions& actions, QWidget* parent)
    : QWidget(parent),
      warning_(messageLabel("panel.feel.warning", tr("Warning"), "amber", this)),
      refusal_(messageLabel("panel.feel.refusal", tr("Why the change was refused"), "alarm", this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  warning_->setToolTip(
      tr("A sampled wall with one tick of delay is stable for K < (b + B) / (1.5 T); b: damping of the hand, B: kd, T: "
         "period of the servo. Lower the stiffness or hold the stylus more firmly."));
  for (QLabel* label : {warning_, refusal_}) {
    label->hide();
    column->addWidget(label);
  }
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  const QStringList names{"edit.undo", "edit.redo", "gains.reset", "scene.save_as"};
  for (int index = 0; index < names.size(); ++index) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions.find(names[index]));
    button->setObjectName("panel.feel.button." + names[index]);
    button->setAccessibleName(button->defaultAction()->iconText());
    button->setIconSize(QSize(1, 1) * fontMetrics().height());
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    grid->addWidget(button, index / 2, index % 2);
  }
  column->addLayout(grid);
}

void FeelFoot::warn(const QString& sentence) {
  showMessage(warning_, sentence);
}

void FeelFoot::refuse(const QString& sentences) {
  showMessage(refusal_, sentences);
}

}  // namespace underact::gui
