#include "app/gui/feel/guide_section.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "app/gui/kit/told_label.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

constexpr scene::CurveGuide kEasy{0.0, 30.0, 8.0};  // t, mm/s, mm
constexpr const char *kGuideSpeed = "/constraints/*/guide/speed_mm_per_s", *kGuideLead = "/constraints/*/guide/lead_mm",
                     *kGuideT = "/constraints/*/guide/t";

}  // namespace

GuideSection::GuideSection(QWidget* parent)
    : QWidget(parent), on_(new QCheckBox(tr("A &guide leads along it"), this)), details_(new QWidget(this)) {
  setObjectName("panel.guide");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  QLabel* title = sectionTitle(tr("Along the curve"), this);
  rows->addWidget(title);
  on_->setObjectName("panel.guide.on");
  on_->setAccessibleName(tr("A guide leads along the curve"));
  on_->setToolTip(
      tr("Off, the stylus is held to the nearest point of the curve. On, a point runs ahead of the hand "
         "along the curve, draws it on, and waits for it."));
  rows->addWidget(on_);
  rows->addWidget(details_);
  buildRows();
  connect(on_, &QCheckBox::toggled, this,
          [this](bool on) { emit changed(switched(on), on ? tr("guide on") : tr("guide off"), true); });
}

void GuideSection::buildRows() {
  speed_ = new ValueRow({settingTip(kGuideSpeed), tr("mm/s"), 1, 200, 0, settingMost(kGuideSpeed)}, "panel.guide.speed",
                        details_);
  speed_->setLabel(tr("Speed"), tr("Speed of the guide"), tr("Speed"));
  t_ = new ValueRow({settingTip(kGuideT), {}, 100, 100, 2, settingMost(kGuideT)}, "panel.guide.t", details_);
  t_->setLabel("t", tr("Influence of the hand's own place on the curve"), tr("Speed"));
  t_->setEnds(tr("guide"), tr("nearest"));
  lead_ =
      new ValueRow({settingTip(kGuideLead), tr("mm"), 1, 50, 1, settingMost(kGuideLead)}, "panel.guide.lead", details_);
  lead_->setLabel(tr("Lead"), tr("Lead of the guide"), tr("Speed"));
  backwards_ = new QCheckBox(tr("bac&kwards"), details_);
  backwards_->setObjectName("panel.guide.backwards");
  backwards_->setAccessibleName(tr("The guide runs backwards"));
  auto* rows = new QVBoxLayout(details_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  for (QWidget* const row : {static_cast<QWidget*>(speed_), static_cast<QWidget*>(backwards_),
                             static_cast<QWidget*>(t_), static_cast<QWidget*>(lead_)})
    rows->addWidget(row);
  const auto ask = [this](double scene::CurveGuide::*number, const QString& what) {
    return [this, number, what](double value, bool fresh) {
      scene::CurveGuide wanted = shown_;
      wanted.*number = value;
      emit changed(wanted, what, fresh);
    };
  };
  connect(t_, &ValueRow::changed, this, ask(&scene::CurveGuide::t, settingLabel(kGuideT)));
  connect(lead_, &ValueRow::changed, this, ask(&scene::CurveGuide::lead_mm, settingLabel(kGuideLead)));
  connect(speed_, &ValueRow::changed, this, [this](double speed_mm_per_s, bool fresh) {
    scene::CurveGuide wanted = shown_;
    wanted.speed_mm_per_s = backwards_->isChecked() ? -speed_mm_per_s : speed_mm_per_s;
    emit changed(wanted, settingLabel(kGuideSpeed), fresh);
  });
  connect(backwards_, &QCheckBox::toggled, this, [this](bool) {
    scene::CurveGuide wanted = shown_;
    wanted.speed_mm_per_s = -wanted.speed_mm_per_s;
    emit changed(wanted, tr("way of the guide"), true);
  });
}

std::optional<scene::CurveGuide> GuideSection::switched(bool on) const {
  return on ? std::optional(shown_) : std::nullopt;
}

void GuideSection::begin(const std::optional<scene::CurveGuide>& own) {
  shown_ = own.value_or(kEasy);
}

bool GuideSection::isHeld() const {
  return speed_->isHeld() || t_->isHeld() || lead_->isHeld();
}

void GuideSection::present(const std::optional<scene::CurveGuide>& now, const std::optional<scene::CurveGuide>& own) {
  if (now) shown_ = *now;
  const QSignalBlocker silent_on(on_), silent_way(backwards_);  // to show a value is not to ask for it
  on_->setChecked(now.has_value());
  details_->setVisible(now.has_value());
  // A speed of 0 has no sign of its own; which way it will go is what was chosen last.
  if (shown_.speed_mm_per_s != 0.0) backwards_->setChecked(shown_.speed_mm_per_s < 0.0);
  speed_->present(std::abs(shown_.speed_mm_per_s), own ? std::optional(std::abs(own->speed_mm_per_s)) : std::nullopt);
  t_->present(shown_.t, own ? std::optional(own->t) : std::nullopt);
  lead_->present(shown_.lead_mm, own ? std::optional(own->lead_mm) : std::nullopt);
}

}  // namespace underact::gui
