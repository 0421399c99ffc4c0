#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/calibration/calibration_panel.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/plot/mark_chart.h"

namespace underact::gui {
namespace {

constexpr const char* kActions[] = {"calibration.left", "calibration.right"};

/// The two beams as in the view, with the one of this side filled.
QIcon beamIcon(std::size_t side, const Theme& theme, const QSize& size, double ratio) {
  QPixmap picture(size * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor grey = mixed(theme.background, theme.ink, 0.6);
  painter.scale(size.width() / 40.0, size.height() / 24.0);
  for (std::size_t beam = 0; beam < 2; ++beam) {
    painter.setPen(QPen(beam == side ? theme.virtual_robot : grey, 1.5));
    painter.setBrush(beam == side ? QBrush(theme.virtual_robot) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(QRectF(beam == 0 ? 5.0 : 27.0, 3.0, 8.0, 18.0), 2.0, 2.0);
  }
  return QIcon(picture);
}

}  // namespace

ProcedurePage* CalibrationPanel::runPage() {
  ProcedurePage* const page = addPage();
  trial_ = new QLabel(page);
  hint_ = quietLabel("panel.calibration.hint", {}, page);
  progress_ = new QProgressBar(page);
  answers_ = new QWidget(page);
  message_ = quietLabel("panel.calibration.said", {}, page);
  trial_->setObjectName("panel.calibration.trial");
  trial_->setProperty("role", "section");
  trial_->setWordWrap(true);
  nameWidget(progress_, "panel.calibration.progress", tr("Reversals"),
             tr("A reversal is a change between harder and easier. The first two only find the rough range; the "
                "just-noticeable difference is the geometric mean of the others (Levitt 1971)."));
  auto* grid = tight<QGridLayout>(answers_, 8);
  const QString names[] = {tr("Left beam"), tr("Right beam")};
  const Qt::Key keys[] = {Qt::Key_Left, Qt::Key_Right};
  for (std::size_t side = 0; side < 2; ++side) {
    QAction* const action = parts_.actions.find(kActions[side]);
    buttons_[side] = answerButton(side, names[side]);
    pressed_[side] = quietLabel(buttons_[side]->objectName() + ".pressed", {}, answers_);
    pressed_[side]->setAccessibleName(tr("%1, pressed or not").arg(names[side]));
    pressed_[side]->setAlignment(Qt::AlignHCenter);
    grid->addWidget(buttons_[side], 0, static_cast<int>(side));
    grid->addWidget(pressed_[side], 1, static_cast<int>(side));
    connect(buttons_[side], &QToolButton::clicked, action, &QAction::trigger);
    // The buttons would use the arrow keys to move the focus.
    auto* arrow = new QShortcut(keys[side], page, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
    connect(arrow, &QShortcut::activated, action, &QAction::trigger);
  }
  auto* cancel = page->button("panel.calibration.cancel", tr("&Cancel"),
                              tr("Restores the stiffness that the scene gives the beams; nothing is kept."),
                              tr("Cancel the measurement"));
  QVBoxLayout* const column = page->column();
  column->addWidget(trial_);
  column->addWidget(hint_);
  column->addWidget(answers_);
  column->addWidget(message_);
  column->addWidget(progress_);
  column->addWidget(cancel);
  column->addStretch(1);
  connect(cancel, &QPushButton::clicked, session_, [this] { session_->cancel(); });
  return page;
}

QToolButton* CalibrationPanel::answerButton(std::size_t side, const QString& name) {
  const QAction* action = parts_.actions.find(kActions[side]);
  auto* button = new QToolButton(answers_);
  nameWidget(button, QLatin1String("panel.") + kActions[side], tr("%1 is stiffer").arg(name), action->toolTip());
  button->setText(tr("%1\n%2").arg(name, action->shortcut().toString(QKeySequence::NativeText)));
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize(QSize(5, 3) * (fontMetrics().lineSpacing() / 2));  // grows with the words below it
  button->setFocusPolicy(Qt::StrongFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setMinimumHeight(5 * fontMetrics().lineSpacing());
  return button;
}

void CalibrationPanel::showRun() {
  const calibration::Measurement& run = session_->run();
  const bool person = session_->setup().who == Answering::Person;
  const auto number = static_cast<int>(run.answers.size()) + 1;
  trial_->setText(person ? tr("Trial %1: which beam is stiffer?").arg(number)
                         : tr("The simulated hand is at trial %1.").arg(number));
  progress_->setRange(0, run.staircase.rule.reversals);
  progress_->setValue(static_cast<int>(run.staircase.reversals.size()));
  progress_->setFormat(tr("reversals %v of %m"));
  answers_->setVisible(person);
  hint_->setText(!person
                     ? tr("It presses the beams on a simulated arm of its own; the arm in the window does not move.")
                 : session_->isServoRunning()
                     ? tr("Press each beam down with the stylus, as often as you like. Release it before you answer.")
                     : tr("The servo is stopped. Press Start to feel the beams."));
  // Otherwise the focus would move from a disabled button to Cancel, where the next Space would end the measurement.
  if (!session_->mayAnswer() && (buttons_[0]->hasFocus() || buttons_[1]->hasFocus())) run_->setFocus();
  for (std::size_t side = 0; side < 2; ++side) {
    const bool pressed = session_->isPressed(static_cast<calibration::Beam>(side));
    pressed_[side]->setText(pressed ? tr("✓ pressed") : tr("press it"));
    buttons_[side]->setEnabled(session_->mayAnswer());
  }
  const bool is_given = feedback_->isChecked() && setup().who == Answering::Person && !run.answers.empty();
  message_->setText(!is_given                      ? QString()
                    : run.answers.back().isRight() ? tr("✓ That was right.")
                                                   : tr("✗ It was the other one."));
  message_->setVisible(is_given);
}

void CalibrationPanel::setTheme(const Theme& theme) {
  chart_->setTheme(theme);
  for (std::size_t side = 0; side < 2; ++side) {
    buttons_[side]->setIcon(beamIcon(side, theme, buttons_[side]->iconSize(), devicePixelRatioF()));
  }
}

}  // namespace underact::gui
