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

constexpr int kSolutions = 8;
constexpr double kSameAngle_rad = 1e-6;

const QString kMinus = QString(QChar(0x2212));

QString signText(std::int8_t sign) {
  return sign > 0 ? QString("+") : kMinus;
}

QString familyText(arm::Family family) {
  return QObject::tr("one of many: only %1 is defined").arg(QString(arm::name(family)).replace('-', QChar(0x2212)));
}

QString limitsText(const arm::Solution& solution, bool is_arm) {
  QString text = solution.within_limits ? QObject::tr("✓ within") : QObject::tr("✗ outside");
  if (solution.family == arm::Family::Q1Free) return text + QObject::tr(", q1 free");
  if (solution.family != arm::Family::None) {
    return text + ", " + QString(arm::name(solution.family)).replace('-', QChar(0x2212));
  }
  return is_arm ? text + QObject::tr(", now") : text;
}

bool isSame(const arm::JointAngles& a_rad, const arm::JointAngles& b_rad) {
  return std::equal(a_rad.begin(), a_rad.end(), b_rad.begin(),
                    [](double a, double b) { return std::abs(std::remainder(a - b, 2.0 * kPi)) < kSameAngle_rad; });
}

QString statusText(const arm::Solutions& solutions) {
  if (!solutions.reachable) return QObject::tr("The arm cannot reach this pose: there is no solution.");
  const auto within =
      std::count_if(solutions.begin(), solutions.end(), [](const arm::Solution& one) { return one.within_limits; });
  QString text = QObject::tr("%1 solutions, %2 within the joint limits.").arg(solutions.count).arg(within);
  QStringList where;
  if (solutions.at_shoulder) where << QObject::tr("shoulder");
  if (solutions.at_elbow) where << QObject::tr("elbow");
  if (solutions.at_wrist) where << QObject::tr("wrist");
  if (!where.isEmpty()) text += QObject::tr(" Singular at the %1.").arg(where.join(QObject::tr(" and ")));
  return text;
}

}  // namespace

SolutionsSection::SolutionsSection(QWidget* parent)
    : Section("solutions", tr("Inverse solutions"),
              tr("All sets of joint angles that give the current pose of the stylus: thesis eq. 3.11 to 3.20 and "
                 "figure 3.4, with their errata."),
              parent),
      status_(quietLabel("panel.kinematics.solutions.status", {}, this)),
      angles_(quietLabel("panel.kinematics.solutions.angles", {}, this)),
      table_(new QTableWidget(kSolutions, 5, this)),
      again_(new QPushButton(tr("&Go there"), this)),
      none_(new QPushButton(tr("Show &none"), this)) {
  status_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  status_->setAlignment(Qt::AlignTop);
  angles_->setFixedHeight(2 * fontMetrics().lineSpacing());
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
  for (QPushButton* button : {again_, none_}) {
    button->setAutoDefault(false);
    button->setEnabled(false);
    buttons->addWidget(button);
  }
  column().addLayout(buttons);
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
}

void SolutionsSection::hideCounts(bool on) {
  status_->setVisible(!on);
}

void SolutionsSection::buildTable() {
  nameWidget(table_, "panel.kinematics.solutions", tr("Inverse solutions"));
  table_->setHorizontalHeaderLabels({tr("no."), tr("shoulder"), tr("elbow"), tr("wrist"), tr("limits")});
  const std::array<QString, 5> tips{
      tr("The number of the solution, as in the view."),
      tr("+: the turret faces the wrist centre; −: it faces away. In the view: the short line at the shoulder."),
      tr("+: cos q3 ≥ 0, as for a real arm; −: the other elbow."),
      tr("+: sin q5 ≥ 0; −: the wrist is bent the other way. In the view: the short line at the tip, axis 5."),
      tr("Whether all joints are within their limits. Now: the current configuration of the arm.")};
  for (int column = 0; column < 5; ++column) {
    table_->horizontalHeaderItem(column)->setToolTip(tips[static_cast<std::size_t>(column)]);
  }
  table_->horizontalHeaderItem(4)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() + 4);
  table_->verticalHeader()->setMinimumSectionSize(fontMetrics().lineSpacing() + 4);
  table_->horizontalHeader()->setSectionsClickable(false);
  table_->horizontalHeader()->setHighlightSections(false);
  for (int column = 0; column < 4; ++column) {
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
  for (int row = 0; row < kSolutions; ++row) {
    const arm::Branch branch = branchOf(row + 1);
    const std::array<QString, 5> texts{QString::number(row + 1), signText(branch.shoulder), signText(branch.elbow),
                                       signText(branch.wrist), QString()};
    for (int column = 0; column < 5; ++column) {
      auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
      if (column < 4) item->setTextAlignment(Qt::AlignCenter);
      table_->setItem(row, column, item);
    }
  }
  const int rows = kSolutions * table_->verticalHeader()->defaultSectionSize();
  table_->setFixedHeight(rows + table_->horizontalHeader()->sizeHint().height() + 2);
}

void SolutionsSection::present(const KinematicsNow& now) {
  solutions_ = now.solutions;
  q_rad_ = now.q_rad;
  const QString status = statusText(solutions_);
  if (status_->text() != status) status_->setText(status);
  std::array<QString, kSolutions> texts;
  texts.fill(QString(QChar(0x2013)));  // no separate solution: it coincides with another one at a singularity
  for (const arm::Solution& one : solutions_) {
    texts[static_cast<std::size_t>(numberOf(one.branch) - 1)] = limitsText(one, isSame(one.q_rad, q_rad_));
  }
  for (int row = 0; row < kSolutions; ++row) {
    QTableWidgetItem* item = table_->item(row, 4);
    const QString& text = texts[static_cast<std::size_t>(row)];
    if (item->text() != text) item->setText(text);
  }
  showChosen();
}

void SolutionsSection::showChosen() {
  QString text;
  if (const int number = chosen(); number > 0) {
    const arm::Solution* found = std::find_if(solutions_.begin(), solutions_.end(), [number](const arm::Solution& one) {
      return numberOf(one.branch) == number;
    });
    if (found == solutions_.end()) {
      text = tr("Solution %1 does not exist here: at a singularity, two solutions coincide.").arg(number);
    } else {
      QStringList angles;
      for (const double angle_rad : arm::firstSix(found->q_rad))
        angles << numberText(angle_rad / kRadPerDegree, 1) + "°";
      text = QString("q = %1").arg(angles.join(", "));
      if (found->family != arm::Family::None) text += "; " + familyText(found->family);
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
