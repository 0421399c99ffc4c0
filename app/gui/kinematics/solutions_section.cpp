#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/kinematics/sections.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kNamedRows = 8;
constexpr double kSameAngle_rad = 1e-6;
/// The columns: the branch of solutions with names, the joint values of others.
enum SolutionColumn { kNumber, kShoulder, kElbow, kWrist, kValues, kLimits, kSolutionColumns };

const QString kMinus = QString(QChar(0x2212));

QString signText(int sign) {
  return sign > 0 ? QString("+") : kMinus;
}

/// "q6-q4" with the sign of arithmetic.
QString plainFamily(const NumberedSolution& solution) {
  return QString::fromStdString(solution.family).replace('-', QChar(0x2212));
}

QString familyText(const NumberedSolution& solution) {
  const QString family = plainFamily(solution);
  const bool moves = family.endsWith(" free") || family.endsWith(" together");
  return moves ? QObject::tr("one of many: %1").arg(family)
               : QObject::tr("one of many: only %1 is defined").arg(family);
}

QString limitsText(const NumberedSolution& solution, bool is_arm) {
  const QString text = solution.within_limits ? QObject::tr("✓ within") : QObject::tr("✗ outside");
  if (solution.family == "q1 free") return text + QObject::tr(", q1 free");
  if (!solution.family.empty()) return text + ", " + plainFamily(solution);
  return is_arm ? text + QObject::tr(", now") : text;
}

QString countText(const NumberedSolutions& solutions) {
  const auto count = static_cast<int>(solutions.all.size());
  const auto within = static_cast<int>(std::count_if(solutions.all.begin(), solutions.all.end(),
                                                     [](const NumberedSolution& one) { return one.within_limits; }));
  if (count == 0) {
    return solutions.is_searched
               ? QObject::tr("A search from %1 starts found no solution for this pose.").arg(kSearchStarts)
               : QObject::tr("The arm cannot reach this pose: there is no solution.");
  }
  if (solutions.has_surplus)
    return QObject::tr(
               "More joints than the pose takes: infinitely many solutions. These %1 are from a search from %2 "
               "starts; %3 are within the joint limits.")
        .arg(count)
        .arg(kSearchStarts)
        .arg(within);
  if (solutions.is_searched)
    return QObject::tr("No closed form: a search from %2 starts found %1 solutions, %3 within the joint limits.")
        .arg(count)
        .arg(kSearchStarts)
        .arg(within);
  return QObject::tr("%1 solutions, %2 within the joint limits.").arg(count).arg(within);
}

QString statusText(const NumberedSolutions& solutions) {
  QStringList where;
  if (solutions.at_shoulder) where << QObject::tr("shoulder");
  if (solutions.at_elbow) where << QObject::tr("elbow");
  if (solutions.at_wrist) where << QObject::tr("wrist");
  const QString text = countText(solutions);
  if (where.isEmpty() || solutions.all.empty()) return text;
  return text + QObject::tr(" Singular at the %1.").arg(where.join(QObject::tr(" and ")));
}

/// The branch in words: shoulder +, elbow -, wrist +.
QString branchText(const NumberedSolution& solution) {
  QStringList words;
  for (const chain::BranchName& one : solution.branch) {
    const std::string_view name = one.name != nullptr ? one.name : "";
    if (name == "shoulder") words << QObject::tr("shoulder") + ' ' + signText(one.choice);
    if (name == "elbow") words << QObject::tr("elbow") + ' ' + signText(one.choice);
    if (name == "wrist") words << QObject::tr("wrist") + ' ' + signText(one.choice);
  }
  return words.join(", ");
}

}  // namespace

SolutionsSection::SolutionsSection(QWidget* parent)
    : Section("solutions", tr("Inverse solutions"),
              tr("All sets of joint values that give the current pose of the stylus; of an arm without a closed form "
                 "those that a search finds. Of a haptic arm: thesis eq. 3.11 to 3.20 and figure 3.4, with their "
                 "errata."),
              parent),
      status_(quietLabel("panel.kinematics.solutions.status", QString(), this)),
      angles_(quietLabel("panel.kinematics.solutions.angles", QString(), this)),
      table_(new QTableWidget(kMaxSolutions, kSolutionColumns, this)),
      again_(new QPushButton(tr("Show the &path"), this)),
      none_(new QPushButton(tr("Show none"), this)),
      move_(new QPushButton(tr("Move the &arm there"), this)),
      why_not_(quietLabel("panel.kinematics.solutions.why_not", QString(), this)) {
  status_->setAlignment(Qt::AlignTop);
  angles_->setAlignment(Qt::AlignTop);
  buildTable();
  nameWidget(again_, "panel.kinematics.solutions.again", tr("Move the ghost to the selected solution"),
             tr("Moves a ghost of the arm at constant speed from the current joint angles to the selected solution."));
  nameWidget(none_, "panel.kinematics.solutions.none", tr("Show none of the solutions"),
             tr("Removes the ghost of the selected solution."));
  column().addWidget(status_);
  column().addWidget(table_);
  column().addWidget(angles_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  nameWidget(move_, "panel.kinematics.solutions.move", tr("Move the arm to the selected solution"),
             tr("Moves the simulated arm from the current joint angles to the selected solution."));
  for (QPushButton* button : {again_, none_, move_}) {
    button->setAutoDefault(false);
    button->setEnabled(false);
    if (button != move_) buttons->addWidget(button);
  }
  column().addLayout(buttons);
  column().addWidget(move_);
  column().addWidget(why_not_);
  why_not_->hide();
  connect(move_, &QPushButton::clicked, this, [this] { emit moveAsked(chosen()); });
  connect(again_, &QPushButton::clicked, this, [this] { emit wanted(chosen()); });
  connect(none_, &QPushButton::clicked, this, [this] { table_->clearSelection(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    again_->setEnabled(chosen() > 0);
    none_->setEnabled(chosen() > 0);
    showChosen();
    emit wanted(chosen());
  });
  // Enter, or a double click, on the selected row: play it again.
  connect(table_, &QTableWidget::itemActivated, this, [this] { emit wanted(chosen()); });
  setArm(*arm::findModel(arm::kDefaultArm), true);
}

void SolutionsSection::hideCounts(bool on) {
  status_->setVisible(!on);
}

void SolutionsSection::setMovable(const QString& refusal) {
  move_->setEnabled(chosen() > 0 && refusal.isEmpty());
  showMessage(why_not_, chosen() > 0 ? refusal : QString());
}

void SolutionsSection::buildTable() {
  nameWidget(table_, "panel.kinematics.solutions", tr("Inverse solutions"));
  table_->setHorizontalHeaderLabels(
      {tr("no."), tr("shoulder"), tr("elbow"), tr("wrist"), tr("joint values"), tr("limits")});
  const std::array<QString, kSolutionColumns> tips{
      tr("The number of the solution, as in the view."),
      tr("+: the turret faces the wrist centre; −: it faces away. In the view: the short line at the shoulder."),
      tr("+: cos q3 ≥ 0, as for a real arm; −: the other elbow."),
      tr("+: sin q5 ≥ 0; −: the wrist is bent the other way. In the view: the short line at the tip, axis 5."),
      tr("Degrees, or mm of a joint that slides."),
      tr("Whether all joints are within their limits. Now: the current configuration of the arm.")};
  for (int column = 0; column < kSolutionColumns; ++column) {
    table_->horizontalHeaderItem(column)->setToolTip(tips[static_cast<std::size_t>(column)]);
  }
  for (const int column : {kValues, kLimits})
    table_->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() + 4);
  table_->verticalHeader()->setMinimumSectionSize(fontMetrics().lineSpacing() + 4);
  table_->horizontalHeader()->setSectionsClickable(false);
  table_->horizontalHeader()->setHighlightSections(false);
  for (int column = 0; column < kValues; ++column) {
    table_->setColumnWidth(column, fontMetrics().horizontalAdvance(table_->horizontalHeaderItem(column)->text()) + 12);
  }
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  for (int row = 0; row < kMaxSolutions; ++row) {
    std::array<QString, kSolutionColumns> texts;
    texts[kNumber] = QString::number(row + 1);
    if (row < kNamedRows) {
      const arm::Branch branch = branchOf(row + 1);
      texts[kShoulder] = signText(branch.shoulder);
      texts[kElbow] = signText(branch.elbow);
      texts[kWrist] = signText(branch.wrist);
    }
    for (int column = 0; column < kSolutionColumns; ++column) {
      auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
      if (column < kValues) item->setTextAlignment(Qt::AlignCenter);
      table_->setItem(row, column, item);
    }
  }
}

void SolutionsSection::setArm(const arm::Model& model, bool is_named) {
  table_->clearSelection();
  model_ = model;
  is_named_ = is_named;
  for (const int column : {kShoulder, kElbow, kWrist}) table_->setColumnHidden(column, !is_named);
  table_->setColumnHidden(kValues, is_named);
  QStringList widest;
  for (std::size_t joint = 0; joint < model.rows.size(); ++joint) widest << kMinus + "000";
  table_->setColumnWidth(kValues, fontMetrics().horizontalAdvance(widest.join(", ")) + 12);
  table_->setMinimumWidth(is_named ? 0 : table_->columnWidth(kNumber) + table_->columnWidth(kValues) + limitsWidth());
  status_->setMinimumHeight((is_named ? 2 : 3) * fontMetrics().lineSpacing());
  angles_->setFixedHeight((is_named ? 2 : 4) * fontMetrics().lineSpacing());
  showRows(is_named ? kNamedRows : 0);
}

/// Of the longest text that is usual there; that of a family is longer.
int SolutionsSection::limitsWidth() const {
  NumberedSolution within, outside;
  within.within_limits = true;
  return std::max(fontMetrics().horizontalAdvance(limitsText(within, true)),
                  fontMetrics().horizontalAdvance(limitsText(outside, false))) +
         12;
}

void SolutionsSection::showRows(int rows) {
  if (rows == rows_) return;
  rows_ = rows;
  for (int row = 0; row < kMaxSolutions; ++row) table_->setRowHidden(row, row >= rows);
  table_->setFixedHeight(rows * table_->verticalHeader()->defaultSectionSize() +
                         table_->horizontalHeader()->sizeHint().height() + 2);
}

bool SolutionsSection::isArm(const NumberedSolution& solution) const {
  for (std::size_t joint = 0; joint < model_.rows.size(); ++joint) {
    const double apart = solution.q[joint] - q_rad_[joint];
    const bool slides = model_.rows[joint].type == chain::JointType::Prismatic;
    if (std::abs(slides ? apart : std::remainder(apart, 2.0 * kPi)) >= kSameAngle_rad) return false;
  }
  return true;
}

QString SolutionsSection::valuesText(const NumberedSolution& solution, int decimals, bool with_units) const {
  QStringList values;
  for (std::size_t joint = 0; joint < model_.rows.size(); ++joint) {
    const bool slides = model_.rows[joint].type == chain::JointType::Prismatic;
    const QString number = numberText(solution.q[joint] / (slides ? kMetrePerMillimetre : kRadPerDegree), decimals);
    values << (!with_units ? number : number + (slides ? " mm" : "°"));
  }
  return values.join(", ");
}

void SolutionsSection::present(const KinematicsNow& now) {
  solutions_ = now.solutions;
  q_rad_ = now.q_rad;
  const QString status = statusText(solutions_);
  if (status_->text() != status) status_->setText(status);
  if (!is_named_) showRows(solutions_.all.empty() ? 0 : std::min(kMaxSolutions, solutions_.all.back().number));
  for (int row = 0; row < rows_; ++row) {
    const NumberedSolution* const one = solutions_.find(row + 1);
    // No separate solution: it coincides with another one at a singularity.
    const QString none = QString(QChar(0x2013));
    const QString limits = one != nullptr ? limitsText(*one, isArm(*one)) : none;
    const QString values = is_named_ || one == nullptr ? QString() : valuesText(*one, 0, false);
    for (const auto& [column, text] : {std::pair{kLimits, limits}, {kValues, values}}) {
      QTableWidgetItem* const item = table_->item(row, column);
      if (item->text() != text) item->setText(text);
    }
  }
  showChosen();
}

void SolutionsSection::showChosen() {
  QString text;
  if (const int number = chosen(); number > 0) {
    const NumberedSolution* const found = solutions_.find(number);
    if (found == nullptr) {
      text = is_named_ ? tr("Solution %1 does not exist here: at a singularity, two solutions coincide.").arg(number)
                       : tr("Solution %1 does not exist here.").arg(number);
    } else {
      text = QString("q = %1").arg(valuesText(*found, 1, true));
      if (!found->family.empty()) text += "; " + familyText(*found);
      if (!is_named_) {
        if (const QString branch = branchText(*found); !branch.isEmpty()) text += "; " + branch;
        for (const std::vector<double>& free : found->null_space) {
          QStringList shares;
          for (const double share : free) shares << numberText(share, 2);
          text += "; " + tr("null space (%1)").arg(shares.join(", "));
        }
      }
    }
  }
  if (angles_->text() != text) angles_->setText(text);
}

void SolutionsSection::choose(int number) {
  if (number > 0)
    table_->selectRow(number - 1);
  else
    table_->clearSelection();
}

int SolutionsSection::chosen() const {
  const QList<QTableWidgetItem*> selected = table_->selectedItems();
  return selected.isEmpty() ? 0 : selected.first()->row() + 1;
}

}  // namespace underact::gui
