#include "app/gui/calibration/calibration_panel.h"

#include <QAction>
#include <QDir>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_library.h"

namespace underact::gui {

using calibration::Beam;

CalibrationPanel::CalibrationPanel(const Parts& parts, QWidget* parent)
    : Panel(parent),
      parts_(parts),
      session_(new CalibrationRun(parts.document, parts.servo, this)),
      pages_(new QStackedWidget) {
  addActions();
  no_beams_ = noBeamsPage();
  begin_ = beginPage();
  run_ = runPage();
  result_ = resultPage();
  pages_->setContentsMargins(8, 8, 8, 8);
  fillWithScroll(this, pages_);
  connect(session_, &CalibrationRun::changed, this, &CalibrationPanel::showState);
  connect(&parts_.document, &Document::opened, this, &CalibrationPanel::sceneOpened);
  showState();
}

ProcedurePage* CalibrationPanel::addPage() {
  auto* page = new ProcedurePage({}, {}, 8);
  page->column()->setContentsMargins({});
  pages_->addWidget(page);
  return page;
}

ProcedurePage* CalibrationPanel::noBeamsPage() {
  ProcedurePage* const page = addPage();
  auto* open =
      page->button("panel.calibration.open", tr("&Open the two beams"), tr("Opens the scene “Two beams, one softer”."));
  page->column()->addWidget(quietLabel("panel.calibration.no_beams",
                                       tr("A threshold measurement needs a scene with two beams whose stiffness can be "
                                          "set. This scene has no such beams."),
                                       page));
  page->column()->addWidget(open);
  page->column()->addStretch(1);
  connect(open, &QPushButton::clicked, this,
          [this] { parts_.actions.perform("scene.open", QDir(sceneFolder()).filePath("23_two_beams.json")); });
  return page;
}

void CalibrationPanel::addActions() {
  const QString tip = tr("Answers that the %1 beam is stiffer; possible once you have pressed both.");
  parts_.actions.add({"calibration.left", tr("Left &beam is stiffer"), QKeySequence("Alt+Left"), tip.arg(tr("left"))},
                     [this](const QVariantList&) { return session_->answer(Beam::Left); });
  parts_.actions.add(
      {"calibration.right", tr("R&ight beam is stiffer"), QKeySequence("Alt+Right"), tip.arg(tr("right"))},
      [this](const QVariantList&) { return session_->answer(Beam::Right); });
  parts_.actions.addCommand("calibration.begin", [this](const QVariantList&) { return begin(); });
  parts_.actions.addCommand("calibration.cancel", [this](const QVariantList&) { return session_->cancel(); });
  parts_.actions.addCommand("calibration.save",
                            [this](const QVariantList& path) { return save(path.value(0).toString()); });
}

void CalibrationPanel::sceneOpened() {
  if (const auto reference = calibration::softerOf(parts_.document.scene())) {
    own_N_per_mm_ = reference.value();  // until another is typed in
    reference_->setValue(own_N_per_mm_);
  }
  showState();
}

void CalibrationPanel::showState() {
  for (const char* name : {"calibration.left", "calibration.right"}) {
    parts_.actions.find(name)->setEnabled(session_->mayAnswer());
  }
  switch (session_->state()) {
    case CalibrationRun::State::Idle:
      showMessage(refusal_, session_->why());
      pages_->setCurrentWidget(calibration::softerOf(parts_.document.scene()) ? begin_ : no_beams_);
      break;
    case CalibrationRun::State::Running:
      showRun();
      pages_->setCurrentWidget(run_);
      break;
    case CalibrationRun::State::Done:
      showResult();
      pages_->setCurrentWidget(result_);
      break;
  }
}

void CalibrationPanel::finish() {
  session_->cancel();  // restores the scene's own stiffness before others read it
}

}  // namespace underact::gui
