#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/registration/pages.h"
#include "app/gui/registration/reference_points_picture.h"
#include "core/base/units.h"

namespace underact::gui {

TouchPage::TouchPage(RegistrationTool& tool, const PreparePage& prepare, QWidget* parent)
    : QWizardPage(parent),
      tool_(tool),
      prepare_(prepare),
      prompt_(messageLabel("registration.prompt", tr("What to do now"), "", this)),
      told_(messageLabel("registration.told", tr("Result of the last press"), "quiet", this)),
      tip_(messageLabel("registration.tip", tr("Position of the tip"), "quiet", this)),
      progress_(new QProgressBar(this)),
      hold_(pushButton("registration.hold", tr("&Hold (Space)"),
                       tr("Records the position of the tip for half a second."), this)),
      again_(pushButton("registration.again", tr("&Touch this point again"),
                        tr("The reference point selected in the table is touched next."), this)),
      table_(pageTable("registration.touched", tr("Reference points and positions of the tip"),
                       {tr("Point"), tr("x, y, z in W, mm"), tr("spread, mm")}, this)),
      picture_(new ReferencePointsPicture("registration.touch_picture", this)) {
  setObjectName("registration.touch");
  setTitle(tr("Touch the reference points"));
  build();
  connect(hold_, &QPushButton::clicked, &tool_.run(), &RegistrationRun::press);
  connect(again_, &QPushButton::clicked, this, [this] {
    if (table_->currentRow() >= 0) tool_.run().touchAgain(static_cast<std::size_t>(table_->currentRow()));
    hold_->setFocus();
  });
  connect(&tool_.run(), &RegistrationRun::changed, this, &TouchPage::showState);
}

void TouchPage::build() {
  QFont large = prompt_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  prompt_->setFont(large);
  nameWidget(progress_, "registration.progress", tr("Progress of the hold"));
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* row = new QHBoxLayout;
  row->addWidget(hold_);
  row->addWidget(progress_, 1);
  row->addWidget(again_);
  auto* both = new QHBoxLayout;
  both->addWidget(table_, 1);
  both->addWidget(picture_, 1);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(8);
  column->addWidget(prompt_);
  column->addLayout(row);
  column->addWidget(told_);
  column->addWidget(tip_);
  column->addLayout(both, 1);
}

void TouchPage::initializePage() {
  tool_.begin(prepare_.which(), prepare_.points_D());
  showState();
  hold_->setFocus();
}

void TouchPage::cleanupPage() {
  tool_.stopTouching();
}

bool TouchPage::isComplete() const {
  return tool_.run().isOn() && tool_.run().touching().isDone() && tool_.run().fit();
}

void TouchPage::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
}

void TouchPage::poll() {
  RegistrationRun& run = tool_.run();
  if (!run.isOn() || !isVisible()) return;
  const QString trouble = tool_.trouble(prepare_.which());
  tip_->setText(!trouble.isEmpty() ? tr("The arm reports: %1").arg(trouble)
                : run.p_WT()       ? tr("Tip: %1").arg(placeText(kMillimetrePerMetre * *run.p_WT()))
                                   : tr("The arm has not sent a sample yet."));
  progress_->setValue(run.touching().isHolding() ? static_cast<int>(100.0 * run.touching().share()) : 0);
}

void TouchPage::showState() {
  RegistrationRun& run = tool_.run();
  if (!run.isOn()) return;
  const registration::Touching& touching = run.touching();
  const std::size_t count = touching.points_D().size(), due = touching.due();
  table_->setRowCount(static_cast<int>(count));
  std::vector<ShownPoint> shown;
  for (std::size_t at = 0; at < count; ++at) {
    const auto& held = touching.held(at);
    const QString texts[] = {QString::number(at + 1), held ? placeText(kMillimetrePerMetre * held->p_WT) : QString(),
                             held ? numberText(kMillimetrePerMetre * held->spread_m, 2) : QString()};
    for (int column = 0; column < 3; ++column)
      table_->setItem(static_cast<int>(at), column, new QTableWidgetItem(texts[column]));
    shown.push_back({touching.points_D()[at], held.has_value()});
  }
  if (due < count) table_->selectRow(static_cast<int>(due));
  picture_->present(shown, due < count ? std::optional(due) : std::nullopt);
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
  if (isVisible() && hold_->isEnabled()) hold_->setFocus();
  emit completeChanged();
}

}  // namespace underact::gui
