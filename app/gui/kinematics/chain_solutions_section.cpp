#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kinematics/sections.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kMost = 16;  // chain::InverseSolutions

}  // namespace

ChainSolutionsSection::ChainSolutionsSection(QWidget* parent)
    : Section("chain_solutions", tr("Inverse solutions"),
              tr("All sets of joint values that give the current pose of the tip, if the arm has a closed form."),
              parent),
      status_(quietLabel("panel.kinematics.chain_solutions.status", {}, this)),
      table_(new NumberTable("panel.kinematics.chain_solutions",
                             {{tr("joint values"), "−000, −000, −000, −000, −000, −000", true},
                              {tr("limits"), tr("✗ outside") + "  ", true}},
                             this)) {
  for (int row = 1; row <= kMost; ++row)
    table_->addRow(QString::number(row), tr("Solution %1: degrees, or mm of a joint that slides.").arg(row));
  column().addWidget(status_);
  column().addWidget(table_);
}

void ChainSolutionsSection::setArm(const arm::Model& model, const chain::Inverse& inverse) {
  model_ = model;
  is_closed_ = inverse.isClosed();
  table_->showOnly(0, 0);
}

void ChainSolutionsSection::hideCounts(bool on) {
  status_->setVisible(!on);
}

void ChainSolutionsSection::present(const KinematicsNow& now) {
  const auto count = static_cast<int>(std::min<std::size_t>(kMost, now.of_chain.size()));
  const auto within = std::count_if(now.of_chain.begin(), now.of_chain.end(),
                                    [](const ChainSolution& one) { return one.within_limits; });
  const QString status = !is_closed_
                             ? tr("This arm has no closed form here; underact-cli ik searches for its solutions.")
                             : tr("%1 solutions, %2 within the joint limits.").arg(count).arg(within);
  if (status_->text() != status) status_->setText(status);
  table_->showOnly(count, count > 0 ? 2 : 0);
  for (int row = 0; row < count; ++row) {
    const ChainSolution& one = now.of_chain[static_cast<std::size_t>(row)];
    QStringList values;
    for (std::size_t joint = 0; joint < one.q.size(); ++joint) {
      const bool slides = model_.rows[joint].type == chain::JointType::Prismatic;
      values << numberText(one.q[joint] / (slides ? kMetrePerMillimetre : kRadPerDegree), 0);
    }
    table_->set(row, 0, values.join(", "));
    table_->set(row, 1, one.within_limits ? tr("✓ within") : tr("✗ outside"));
  }
}

}  // namespace underact::gui
