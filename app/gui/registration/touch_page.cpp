#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/registration/reference_points_picture.h"
#include "app/gui/registration/registration_wizard.h"
#include "core/base/units.h"

namespace underact::gui {

ProcedurePage* RegistrationWizard::touchPage() {
  touch_ = new ProcedurePage("registration.touch", tr("Touch the reference points"), 8);
  prompt_ = messageLabel("registration.prompt", tr("What to do now"), "", touch_);
  QFont large = prompt_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  prompt_->setFont(large);
  told_ = messageLabel("registration.told", tr("Result of the last press"), "quiet", touch_);
  tip_ = messageLabel("registration.tip", tr("Position of the tip"), "quiet", touch_);
  progress_ = new QProgressBar(touch_);
  nameWidget(progress_, "registration.progress", tr("Progress of the hold"));
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  hold_ = pushButton("registration.hold", tr("&Hold (Space)"), tr("Records the position of the tip for half a second."),
                     touch_);
  again_ = pushButton("registration.again", tr("&Touch this point again"),
                      tr("The reference point selected in the table is touched next."), touch_);
  auto* row = new QHBoxLayout;
  row->addWidget(hold_);
  row->addWidget(progress_, 1);
  row->addWidget(again_);
  touch_->column()->addWidget(prompt_);
  touch_->column()->addLayout(row);
  touch_->column()->addWidget(told_);
  touch_->column()->addWidget(tip_);
  touched_ = touch_->table("registration.touched", tr("Reference points and positions of the tip"),
                           {tr("Point"), tr("x, y, z in W, mm"), tr("spread, mm")});
  touch_picture_ = addPicture(touch_, touched_, "registration.touch_picture");
  touch_->enter = [this] {
    tool_.begin(which(), points_D());
    showTouches();
    hold_->setFocus();
  };
  touch_->leave = [this] { tool_.stopTouching(); };
  touch_->is_ready = [this] { return tool_.run().isOn() && tool_.run().touching().isDone() && tool_.run().fit(); };
  connect(hold_, &QPushButton::clicked, &tool_.run(), &RegistrationRun::press);
  connect(again_, &QPushButton::clicked, this, [this] {
    if (touched_->currentRow() >= 0) tool_.run().touchAgain(static_cast<std::size_t>(touched_->currentRow()));
    hold_->setFocus();
  });
  connect(&tool_.run(), &RegistrationRun::changed, this, &RegistrationWizard::showTouches);
  return touch_;
}

void RegistrationWizard::pollTip() {
  RegistrationRun& run = tool_.run();
  if (!run.isOn() || !touch_->isVisible()) return;
  const QString trouble = tool_.trouble(which());
  tip_->setText(!trouble.isEmpty() ? tr("The arm reports: %1").arg(trouble)
                : run.p_WT()       ? tr("Tip: %1").arg(placeText(kMillimetrePerMetre * *run.p_WT()))
                                   : tr("The arm has not sent a sample yet."));
  progress_->setValue(run.touching().isHolding() ? static_cast<int>(100.0 * run.touching().share()) : 0);
}

void RegistrationWizard::showTouches() {
  RegistrationRun& run = tool_.run();
  if (!run.isOn()) return;
  const registration::Touching& touching = run.touching();
  const std::size_t count = touching.points_D().size(), due = touching.due();
  touched_->setRowCount(static_cast<int>(count));
  std::vector<ShownPoint> shown;
  for (std::size_t at = 0; at < count; ++at) {
    const auto& held = touching.held(at);
    setRow(touched_, static_cast<int>(at),
           {QString::number(at + 1), held ? placeText(kMillimetrePerMetre * held->p_WT) : QString(),
            held ? numberText(kMillimetrePerMetre * held->spread_m, 2) : QString()});
    shown.push_back({touching.points_D()[at], held.has_value()});
  }
  if (due < count) touched_->selectRow(static_cast<int>(due));
  touch_picture_->present(shown, due < count ? std::optional(due) : std::nullopt);
  QString told = run.told();
  if (touching.isDone()) {
    prompt_->setText(tr("All reference points have been touched."));
    if (const Result<registration::Fit> fit = run.fit(); !fit) told = sentencesOf(fit.problems());
  } else {
    prompt_->setText(
        tr("Rest the tip on reference point %1 and press the stylus button, or Space. The force is off.").arg(due + 1));
  }
  told_->setText(told);
  hold_->setEnabled(!touching.isHolding() && due < count);
  again_->setEnabled(!touching.isHolding());
  if (touch_->isVisible() && hold_->isEnabled()) hold_->setFocus();
  emit touch_->completeChanged();
}

}  // namespace underact::gui
