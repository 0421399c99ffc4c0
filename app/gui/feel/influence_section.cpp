#include "app/gui/feel/influence_section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/kit/told_label.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

constexpr const char *kInfluenceT = "/constraints/*/influence/t", *kBlend = "/constraints/*/influence/blend_deg",
                     *kStylusAxis = "/constraints/*/influence/stylus_axis";

}  // namespace

InfluenceSection::InfluenceSection(QWidget* parent)
    : QWidget(parent), on_(new QCheckBox(tr("&Turn of the stylus counts"), this)), details_(new QWidget(this)) {
  setObjectName("panel.influence");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  QLabel* title = sectionTitle(tr("Influence t"), this);
  title->setToolTip(
      tr("Where on the circle, cylinder or sphere the target is, between the point the stylus points at and the point "
         "nearest to its tip: theta = alpha + t wrap(beta - alpha) (thesis equation 5.3)."));
  rows->addWidget(title);
  on_->setObjectName("panel.influence.on");
  on_->setAccessibleName(tr("Turn of the stylus counts"));
  on_->setToolTip(tr("Off, the target is the nearest point: position only. On, turning the stylus moves the target."));
  rows->addWidget(on_);
  rows->addWidget(details_);
  buildRows();
  connect(on_, &QCheckBox::toggled, this,
          [this](bool on) { emit changed(switched(on), on ? tr("influence on") : tr("influence off"), true); });
}

void InfluenceSection::buildRows() {
  t_ =
      new ValueRow({settingTip(kInfluenceT), {}, 100, 100, 3, settingMost(kInfluenceT)}, "panel.influence.t", details_);
  t_->setLabel("t", tr("Influence t"), tr("Blend"));
  t_->setEnds(tr("orientation"), tr("position"));
  blend_ =
      new ValueRow({settingTip(kBlend), tr("°"), 2, 60, 1, settingMost(kBlend)}, "panel.influence.blend", details_);
  blend_->setLabel(tr("Blend"), tr("Blend width"), tr("Blend"));
  axis_ = new QComboBox(details_);
  axis_->setObjectName("panel.influence.axis");
  axis_->setAccessibleName(tr("Direction of the stylus that counts"));
  axis_->setToolTip(settingTip(kStylusAxis));
  axis_->addItems({tr("+z, from the tip to the hand"), tr("−z, from the hand to the tip")});
  axis_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  axis_->setMinimumContentsLength(8);
  axis_->setFocusPolicy(Qt::StrongFocus);
  auto* rows = new QVBoxLayout(details_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  rows->addWidget(t_);
  auto* choice = new QFormLayout;
  choice->setHorizontalSpacing(12);
  choice->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  choice->addRow(tr("&Stylus axis"), axis_);
  rows->addLayout(choice);
  rows->addWidget(blend_);

  connect(t_, &ValueRow::changed, this, [this](double t, bool fresh) {
    scene::Influence wanted = shown_;
    wanted.t = t;
    emit changed(wanted, settingLabel(kInfluenceT), fresh);
  });
  connect(blend_, &ValueRow::changed, this, [this](double blend_deg, bool fresh) {
    scene::Influence wanted = shown_;
    wanted.blend_deg = blend_deg;
    emit changed(wanted, settingLabel(kBlend), fresh);
  });
  connect(axis_, &QComboBox::currentIndexChanged, this, [this](int row) {
    scene::Influence wanted = shown_;
    wanted.stylus_axis = static_cast<scene::StylusAxis>(row);
    emit changed(wanted, settingLabel(kStylusAxis), true);
  });
}

std::optional<scene::Influence> InfluenceSection::switched(bool on) const {
  return on ? std::optional(shown_) : std::nullopt;
}

void InfluenceSection::begin(const std::optional<scene::Influence>& own, bool has_axis) {
  shown_ = own.value_or(scene::Influence{});
  blend_->setVisible(has_axis);
}

bool InfluenceSection::isHeld() const {
  return t_->isHeld() || blend_->isHeld();
}

void InfluenceSection::present(const std::optional<scene::Influence>& now, const std::optional<scene::Influence>& own) {
  if (now) shown_ = *now;
  const QSignalBlocker silent_on(on_), silent_axis(axis_);  // to show a value is not to ask for it
  on_->setChecked(now.has_value());
  details_->setVisible(now.has_value());
  axis_->setCurrentIndex(static_cast<int>(shown_.stylus_axis));
  t_->present(shown_.t, own ? std::optional(own->t) : std::nullopt);
  blend_->present(shown_.blend_deg, own ? std::optional(own->blend_deg) : std::nullopt);
}

}  // namespace underact::gui
