#include "app/gui/calibration/calibration_panel.h"

#include <QAction>
#include <QDir>
#include <QPushButton>
#include <QSaveFile>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/calibration/begin_page.h"
#include "app/gui/calibration/result_page.h"
#include "app/gui/calibration/run_page.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/tight_layout.h"
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
  pages_->addWidget(no_beams_ = makeNoBeamsPage());
  pages_->addWidget(begin_ = new BeginPage);
  pages_->addWidget(run_ = new RunPage(parts_.actions));
  pages_->addWidget(result_ = new ResultPage);
  pages_->setContentsMargins(8, 8, 8, 8);
  fillWithScroll(this, pages_);
  connect(session_, &CalibrationRun::changed, this, &CalibrationPanel::showState);
  connect(begin_, &BeginPage::begin, this, &CalibrationPanel::begin);
  connect(run_, &RunPage::cancelled, session_, [this] { session_->cancel(); });
  connect(result_, &ResultPage::again, session_, &CalibrationRun::leave);
  connect(result_, &ResultPage::save, this, &CalibrationPanel::chooseAndSave);
  connect(&parts_.document, &Document::opened, this, &CalibrationPanel::sceneOpened);
  showState();
}

QWidget* CalibrationPanel::makeNoBeamsPage() {
  auto* page = new QWidget;
  auto* open = new QPushButton(tr("&Open the two beams"), page);
  nameWidget(open, "panel.calibration.open", tr("Open the two beams"), tr("Opens the scene “Two beams, one softer”."));
  auto* column = tight<QVBoxLayout>(page, 8);
  column->addWidget(quietLabel(
      "panel.calibration.no_beams",
      tr("A calibration needs a scene with two beams whose stiffness can be set. This scene has no such beams."),
      page));
  column->addWidget(open);
  column->addStretch(1);
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
  if (const auto reference = calibration::softerOf(parts_.document.scene())) begin_->setReference(reference.value());
  showState();
}

bool CalibrationPanel::begin() {
  const bool had_focus = begin_->isAncestorOf(focusWidget());
  const Problems problems = session_->begin(begin_->setup());
  if (!problems.empty()) {
    begin_->setNote(sentencesOf(problems));
    return false;
  }
  begin_->remember();
  if (had_focus) run_->setFocus();  // for the arrow keys
  return true;
}

void CalibrationPanel::showState() {
  for (const char* name : {"calibration.left", "calibration.right"}) {
    parts_.actions.find(name)->setEnabled(session_->mayAnswer());
  }
  switch (session_->state()) {
    case CalibrationRun::State::Idle:
      begin_->setNote(session_->why());
      pages_->setCurrentWidget(calibration::softerOf(parts_.document.scene()) ? static_cast<QWidget*>(begin_)
                                                                              : no_beams_);
      break;
    case CalibrationRun::State::Running:
      run_->present(*session_, begin_->saysWhetherRight());
      pages_->setCurrentWidget(run_);
      break;
    case CalibrationRun::State::Done:
      result_->present(*session_);
      pages_->setCurrentWidget(result_);
      break;
  }
}

void CalibrationPanel::finish() {
  session_->cancel();  // restores the scene's own stiffness before others read it
}

void CalibrationPanel::present(const servo::Snapshot& snapshot) {
  session_->present(snapshot);
}

void CalibrationPanel::setTheme(const Theme& theme) {
  run_->setTheme(theme);
  result_->setTheme(theme);
}

bool CalibrationPanel::save(const QString& path) {
  if (session_->state() != CalibrationRun::State::Done || path.isEmpty()) return false;
  const CalibrationSetup& setup = session_->setup();
  const QString who = setup.who == Answering::Person
                          ? QStringLiteral("a person")
                          : QStringLiteral("a simulated hand with a Weber fraction of %1").arg(setup.weber);
  const std::string csv = calibration::csvOf(session_->run(), who.toStdString(), setup.seed);
  QSaveFile file(path);  // whole or not at all; a person's threshold is private
  const bool saved = file.open(QIODevice::WriteOnly) && file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) &&
                     file.write(csv.c_str()) >= 0 && file.commit();
  result_->setNote(saved ? tr("Saved as %1.").arg(QDir::toNativeSeparators(path))
                         : tr("Not saved: %1. Choose another folder.").arg(file.errorString()));
  return saved;
}

void CalibrationPanel::chooseAndSave() {
  askWhereToSave(this, "dialog.save_calibration", tr("Save the trials"), "jnd.csv", tr("Tables (*.csv);;All files (*)"),
                 [this](const QString& path) { save(path); });
}

}  // namespace underact::gui
