#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
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
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/registration/pages.h"
#include "app/gui/registration/reference_points_picture.h"
#include "app/gui/registration/sheet.h"
#include "core/base/units.h"
#include "core/registration/sheet.h"

namespace underact::gui {
namespace {

using Which = RegistrationTool::Which;

constexpr double kFarthest_mm = 1000.0;

}  // namespace

QTableWidget* pageTable(const char* name, const QString& spoken, const QStringList& columns, QWidget* parent) {
  auto* table = new QTableWidget(0, static_cast<int>(columns.size()), parent);
  nameWidget(table, name, spoken);
  table->setHorizontalHeaderLabels(columns);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->verticalHeader()->hide();
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  return table;
}

PreparePage::PreparePage(RegistrationTool& tool, QWidget* parent) : QWizardPage(parent), tool_(tool) {
  setObjectName("registration.prepare");
  setTitle(tr("Where does the arm stand?"));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(8);
  QLabel* what = messageLabel("registration.what", tr("What this is for"), "", this);
  what->setText(
      tr("You touch reference points on the desk, whose positions are known, with the tip of the stylus. From these "
         "the program finds the pose of the arm: the view is turned so that left on the desk is left in the picture, "
         "and two arms are drawn where they stand. Tape the sheet to the desk, and then move neither the sheet nor the "
         "arm. The scene and its forces stay where they are in the arm's own frame."));
  column->addWidget(what);
  column->addWidget(buildArm());
  column->addWidget(buildMarks(), 1);
  connect(&tool_, &RegistrationTool::changed, this, &PreparePage::showArm);
  fillMarks();
  showArm();
}

QWidget* PreparePage::buildArm() {
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box);
  arm_ = chooser("registration.arm", tr("Arm"), tr("Which arm to register."), box);
  state_ = messageLabel("registration.state", tr("Whether the arm is registered"), "quiet", box);
  calibration_ = messageLabel("registration.calibration", tr("Whether the arm is calibrated"), "", box);
  forget_ =
      pushButton("registration.forget", tr("&Forget this registration"),
                 tr("Deletes the registration of this arm. The view then shows the arm as if it stood straight."), box);
  column->addWidget(arm_);
  column->addWidget(calibration_);
  column->addWidget(state_);
  column->addWidget(forget_, 0, Qt::AlignLeft);
  connect(arm_, &QComboBox::currentIndexChanged, this, &PreparePage::showArm);
  connect(forget_, &QPushButton::clicked, this, &PreparePage::forget);
  return box;
}

QWidget* PreparePage::buildMarks() {
  auto* box = new QWidget(this);
  auto* column = tight<QVBoxLayout>(box);
  count_ = new QSpinBox(box);
  nameWidget(count_, "registration.count", tr("Number of reference points"),
             tr("More reference points make the error smaller, and better known. Restores the positions of the printed "
                "sheet."));
  count_->setRange(static_cast<int>(registration::kFewestMarks), static_cast<int>(registration::kMostMarks));
  count_->setSuffix(tr(" points"));
  paper_ = chooser("registration.paper", tr("Paper"), tr("The paper to print the sheet on."), box);
  paper_->addItems({tr("A4"), tr("Letter")});
  sheet_ = pushButton("registration.sheet", tr("Save the &sheet as PDF…"),
                      tr("Saves the sheet of reference points. Print it at 100 %, and check its ruler."), box);
  auto* row = new QHBoxLayout;
  row->addWidget(count_);
  row->addStretch(1);
  row->addWidget(paper_);
  row->addWidget(sheet_);
  table_ = pageTable("registration.marks", tr("Positions of the reference points, mm from point 1"),
                     {tr("Point"), tr("right, mm"), tr("away, mm"), tr("up, mm")}, box);
  table_->setToolTip(
      tr("Positions of the reference points, from point 1: to the right, away from you, up. You can type in points of "
         "your own."));
  picture_ = new ReferencePointsPicture("registration.sheet_picture", box);
  layout_ = messageLabel("registration.layout", tr("Layout of the reference points"), "warning", box);
  auto* both = new QHBoxLayout;
  both->addWidget(table_, 1);
  both->addWidget(picture_, 1);
  column->addLayout(row);
  column->addLayout(both, 1);
  column->addWidget(layout_);
  connect(count_, &QSpinBox::valueChanged, this, &PreparePage::fillMarks);
  connect(table_, &QTableWidget::itemChanged, this, &PreparePage::showMarks);
  connect(sheet_, &QPushButton::clicked, this, &PreparePage::chooseSheet);
  return box;
}

Which PreparePage::which() const {
  return arm_->currentIndex() == 1 ? Which::Second : Which::First;
}

std::vector<Vec3> PreparePage::points_D() const {
  std::vector<Vec3> points_D;
  for (int row = 0; row < table_->rowCount(); ++row) {
    Vec3 place_m;  // right, away, up
    for (int column = 0; column < 3; ++column) {
      place_m[column] = kMetrePerMillimetre * typed(table_->item(row, column + 1)->text()).value_or(kNotANumber);
    }
    points_D.push_back(registration::onDesk(place_m[0], place_m[1], place_m[2]));
  }
  return points_D;
}

void PreparePage::fillMarks() {
  const QSignalBlocker quiet(table_);
  const std::vector<Vec3> points_D = registration::sheetPoints(static_cast<std::size_t>(count_->value()));
  table_->setRowCount(static_cast<int>(points_D.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const Vec3& mark_D = points_D[static_cast<std::size_t>(row)];
    auto* number = new QTableWidgetItem(QString::number(row + 1));
    number->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    table_->setItem(row, 0, number);
    const double place_m[] = {registration::rightOf(mark_D), registration::awayOf(mark_D), registration::upOf(mark_D)};
    for (int column = 0; column < 3; ++column)
      table_->setItem(row, column + 1, new QTableWidgetItem(numberText(kMillimetrePerMetre * place_m[column], 1)));
  }
  showMarks();
}

/// Says what is wrong with the reference points before any is touched, as if they had been touched without error.
void PreparePage::showMarks() {
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
  picture_->present(shown, {});
  emit completeChanged();
}

void PreparePage::showArm() {
  const QSignalBlocker quiet(arm_);
  const int chosen = std::max(0, arm_->currentIndex());
  arm_->clear();
  arm_->addItem(tool_.title(Which::First));
  if (tool_.hasSecond()) arm_->addItem(tool_.title(Which::Second));
  arm_->setCurrentIndex(std::min(chosen, arm_->count() - 1));
  state_->setText(tool_.sentence(which()));
  forget_->setVisible(tool_.of(which()).has_value());
  poll();
}

void PreparePage::poll() {
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
  emit completeChanged();
}

void PreparePage::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
}

void PreparePage::forget() {
  const Problems problems = tool_.forget(which());
  if (!problems.empty()) state_->setText(sentencesOf(problems));
}

bool PreparePage::saveSheet(const QString& path) {
  const Paper paper = paper_->currentIndex() == 1 ? Paper::Letter : Paper::A4;
  const Problems problems = gui::saveSheet(path, points_D(), paper);
  layout_->setText(problems.empty() ? tr("The sheet was saved as %1. Print it at 100 %, and check its ruler.").arg(path)
                                    : sentencesOf(problems));
  layout_->show();
  return problems.empty();
}

void PreparePage::chooseSheet() {
  askWhereToSave(this, "dialog.registration_sheet", tr("Save the sheet"), "underact_marks.pdf", tr("PDF (*.pdf)"),
                 [this](const QString& path) { saveSheet(path); });
}

}  // namespace underact::gui
