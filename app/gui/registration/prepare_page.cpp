#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/registration/reference_points_picture.h"
#include "app/gui/registration/registration_wizard.h"
#include "app/gui/registration/sheet.h"
#include "core/base/units.h"
#include "core/registration/sheet.h"

namespace underact::gui {
namespace {

using Which = RegistrationTool::Which;

constexpr double kFarthest_mm = 1000.0;

}  // namespace

ProcedurePage* RegistrationWizard::preparePage() {
  prepare_ = new ProcedurePage("registration.prepare", tr("Where does the arm stand?"), 8);
  QLabel* what = messageLabel("registration.what", tr("What this is for"), "", prepare_);
  what->setText(
      tr("You touch reference points on the desk, whose positions are known, with the tip of the stylus. From these "
         "the program finds the pose of the arm: the view is turned so that left on the desk is left in the picture, "
         "and two arms are drawn where they stand. Tape the sheet to the desk, and then move neither the sheet nor the "
         "arm. The scene and its forces stay where they are in the arm's own frame."));
  prepare_->column()->addWidget(what);
  addArm();
  addMarks();
  prepare_->is_ready = [this] { return is_ready_ && marks_are_good_; };
  connect(&tool_, &RegistrationTool::changed, this, &RegistrationWizard::showArm);
  fillMarks();
  showArm();
  return prepare_;
}

void RegistrationWizard::addArm() {
  arm_ = chooser("registration.arm", tr("Arm"), tr("Which arm to register."), prepare_);
  state_ = messageLabel("registration.state", tr("Whether the arm is registered"), "quiet", prepare_);
  calibration_ = messageLabel("registration.calibration", tr("Whether the arm is calibrated"), "", prepare_);
  forget_ = pushButton("registration.forget", tr("&Forget this registration"),
                       tr("Deletes the registration of this arm. The view then shows the arm as if it stood straight."),
                       prepare_);
  prepare_->column()->addWidget(arm_);
  prepare_->column()->addWidget(calibration_);
  prepare_->column()->addWidget(state_);
  prepare_->column()->addWidget(forget_, 0, Qt::AlignLeft);
  connect(arm_, &QComboBox::currentIndexChanged, this, &RegistrationWizard::showArm);
  connect(forget_, &QPushButton::clicked, this, &RegistrationWizard::forget);
}

void RegistrationWizard::addMarks() {
  count_ = new QSpinBox(prepare_);
  nameWidget(count_, "registration.count", tr("Number of reference points"),
             tr("More reference points make the error smaller, and better known. Restores the positions of the printed "
                "sheet."));
  count_->setRange(static_cast<int>(registration::kFewestMarks), static_cast<int>(registration::kMaxMarks));
  count_->setSuffix(tr(" points"));
  paper_ = chooser("registration.paper", tr("Paper"), tr("The paper to print the sheet on."), prepare_);
  paper_->addItems({tr("A4"), tr("Letter")});
  sheet_ = pushButton("registration.sheet", tr("Save the &sheet as PDF…"),
                      tr("Saves the sheet of reference points. Print it at 100 %, and check its ruler."), prepare_);
  auto* row = new QHBoxLayout;
  row->addWidget(count_);
  row->addStretch(1);
  row->addWidget(paper_);
  row->addWidget(sheet_);
  prepare_->column()->addLayout(row);
  marks_ = prepare_->table("registration.marks", tr("Positions of the reference points, mm from point 1"),
                           {tr("Point"), tr("right, mm"), tr("away, mm"), tr("up, mm")});
  marks_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  marks_->setToolTip(
      tr("Positions of the reference points, from point 1: to the right, away from you, up. You can type in points of "
         "your own."));
  marks_picture_ = addPicture(prepare_, marks_, "registration.sheet_picture");
  layout_ = messageLabel("registration.layout", tr("Layout of the reference points"), "warning", prepare_);
  prepare_->column()->addWidget(layout_);
  connect(count_, &QSpinBox::valueChanged, this, &RegistrationWizard::fillMarks);
  connect(marks_, &QTableWidget::itemChanged, this, &RegistrationWizard::showMarks);
  connect(sheet_, &QPushButton::clicked, this, [this] {
    askWhereToSave(this, "dialog.registration_sheet", tr("Save the sheet"), "underact_marks.pdf", tr("PDF (*.pdf)"),
                   [this](const QString& path) { saveSheet(path); });
  });
}

Which RegistrationWizard::which() const {
  return arm_->currentIndex() == 1 ? Which::Second : Which::First;
}

std::vector<Vec3> RegistrationWizard::points_D() const {
  std::vector<Vec3> points_D;
  for (int row = 0; row < marks_->rowCount(); ++row) {
    Vec3 place_m;  // right, away, up
    for (int column = 0; column < 3; ++column) {
      place_m[column] = kMetrePerMillimetre * typed(marks_->item(row, column + 1)->text()).value_or(kNotANumber);
    }
    points_D.push_back(registration::onDesk(place_m[0], place_m[1], place_m[2]));
  }
  return points_D;
}

void RegistrationWizard::fillMarks() {
  const QSignalBlocker quiet(marks_);
  const std::vector<Vec3> points_D = registration::sheetPoints(static_cast<std::size_t>(count_->value()));
  marks_->setRowCount(static_cast<int>(points_D.size()));
  for (int row = 0; row < marks_->rowCount(); ++row) {
    const Vec3& mark_D = points_D[static_cast<std::size_t>(row)];
    setRow(marks_, row,
           {QString::number(row + 1), numberText(kMillimetrePerMetre * registration::rightOf(mark_D), 1),
            numberText(kMillimetrePerMetre * registration::awayOf(mark_D), 1),
            numberText(kMillimetrePerMetre * registration::upOf(mark_D), 1)});
    marks_->item(row, 0)->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  }
  showMarks();
}

/// Says what is wrong with the reference points before any is touched, as if they had been touched without error.
void RegistrationWizard::showMarks() {
  const std::vector<Vec3> points_D = this->points_D();
  std::vector<registration::Touch> touches;
  std::vector<ShownPoint> shown;
  bool all_near = true;
  for (const Vec3& mark_D : points_D) {
    touches.push_back({mark_D, mark_D, 0.0});
    all_near = all_near && mark_D.allFinite() && mark_D.cwiseAbs().maxCoeff() <= kMetrePerMillimetre * kFarthest_mm;
    shown.push_back({mark_D});
  }
  QStringList sentences;
  marks_are_good_ = false;
  if (!all_near) {
    sentences << tr("Each coordinate must be a number from -1000 to 1000 mm.");
    shown.clear();
  } else if (const Result<registration::Fit> fit = fitTouches(touches); !fit) {
    sentences << sentencesOf(fit.problems());
  } else {
    marks_are_good_ = true;
    for (const registration::Warning& warning : warningsOf(touches, fit.value()))
      sentences << sentenceText(warning.sentence);
  }
  showMessage(layout_, sentences.join('\n'));
  sheet_->setEnabled(marks_are_good_);
  marks_picture_->present(shown, {});
  emit prepare_->completeChanged();
}

void RegistrationWizard::showArm() {
  const QSignalBlocker quiet(arm_);
  const int chosen = std::max(0, arm_->currentIndex());
  arm_->clear();
  arm_->addItem(tool_.title(Which::First));
  if (tool_.hasSecond()) arm_->addItem(tool_.title(Which::Second));
  arm_->setCurrentIndex(std::min(chosen, arm_->count() - 1));
  state_->setText(tool_.sentence(which()));
  forget_->setVisible(tool_.of(which()).has_value());
  pollArm();
}

void RegistrationWizard::pollArm() {
  const QString refusal = tool_.refusalReason(), trouble = tool_.trouble(which());
  const bool is_ready = refusal.isEmpty() && trouble.isEmpty();
  const QString sentence = !refusal.isEmpty()   ? refusal
                           : !trouble.isEmpty() ? tr("The arm reports: %1").arg(trouble)
                           : tool_.isSimulated(which())
                               ? tr("A simulated arm needs no calibration. Move its hand in the view.")
                               : tr("The arm reports that it is calibrated and that nothing is missing.");
  if (sentence == calibration_->text() && is_ready == is_ready_) return;
  calibration_->setText(sentence);
  calibration_->setProperty("role", is_ready ? "" : "warning");
  calibration_->style()->polish(calibration_);
  is_ready_ = is_ready;
  emit prepare_->completeChanged();
}

void RegistrationWizard::forget() {
  const Problems problems = tool_.forget(which());
  if (!problems.empty()) state_->setText(sentencesOf(problems));
}

bool RegistrationWizard::saveSheet(const QString& path) {
  const Paper paper = paper_->currentIndex() == 1 ? Paper::Letter : Paper::A4;
  const Problems problems = gui::saveSheet(path, points_D(), paper);
  layout_->setText(problems.empty() ? tr("The sheet was saved as %1. Print it at 100 %, and check its ruler.").arg(path)
                                    : sentencesOf(problems));
  layout_->show();
  return problems.empty();
}

}  // namespace underact::gui
