#include "app/gui/feel/surface_section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/told_label.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

constexpr scene::Friction kWood{0.4, 0.3};  // on wood, about
constexpr const char *kStatic = "/constraints/*/friction/static", *kDynamic = "/constraints/*/friction/dynamic",
                     *kSmooth = "/constraints/*/smooth_deg", *kSearch = "/constraints/*/search";
constexpr int kStepsPerUnit = 100, kSliderSteps = 150;
constexpr int kSmoothSteps_deg = 45;

}  // namespace

SurfaceSection::SurfaceSection(QWidget* parent)
    : QWidget(parent),
      on_(new QCheckBox(tr("The surface has f&riction"), this)),
      details_(new QWidget(this)),
      smooth_(new ValueRow({settingTip(kSmooth), tr("°"), 1, kSmoothSteps_deg, 1, settingMost(kSmooth)},
                           "panel.surface.smooth", this)),
      search_line_(new QWidget(this)) {
  setObjectName("panel.surface");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  QLabel* title = sectionTitle(tr("Surface"), this);
  rows->addWidget(title);
  on_->setObjectName("panel.surface.friction");
  on_->setAccessibleName(tr("The surface has friction"));
  on_->setToolTip(
      tr("Off, the stylus glides along the surface. On, it sticks up to the static share of the force "
         "across the surface, and drags by the dynamic share beyond (Coulomb)."));
  rows->addWidget(on_);
  rows->addWidget(details_);
  buildRows();
  smooth_->setLabel(tr("Smooth"), tr("Smooth bends"), tr("Dynamic"));
  rows->addWidget(smooth_);
  connect(smooth_, &ValueRow::changed, this,
          [this](double smooth_deg, bool fresh) { emit asked("/smooth_deg", smooth_deg, fresh); });
  search_ = chooser("panel.surface.search", tr("How the nearest point of the mesh is sought"), settingTip(kSearch),
                    search_line_);
  search_->addItems({tr("nearest of all"), tr("nearest of all, in the tree"), tr("along the surface")});
  auto* line = new QFormLayout(search_line_);
  line->setContentsMargins(0, 0, 0, 0);
  line->setHorizontalSpacing(12);
  line->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  line->addRow(tr("&Held to"), search_);
  rows->addWidget(search_line_);
  connect(on_, &QCheckBox::toggled, this,
          [this](bool on) { emit frictionChanged(switched(on), on ? tr("friction on") : tr("friction off"), true); });
  connect(search_, &QComboBox::currentIndexChanged, this, [this](int row) {
    emit asked("/search", scene::findSetting(kSearch)->words()[static_cast<std::size_t>(row)], true);
  });
}

void SurfaceSection::buildRows() {
  static_ = new ValueRow({settingTip(kStatic), {}, kStepsPerUnit, kSliderSteps, 2, settingMost(kStatic)},
                         "panel.surface.static", details_);
  static_->setLabel(tr("Static"), tr("Static friction"), tr("Dynamic"));
  dynamic_ = new ValueRow({settingTip(kDynamic), {}, kStepsPerUnit, kSliderSteps, 2, settingMost(kDynamic)},
                          "panel.surface.dynamic", details_);
  dynamic_->setLabel(tr("Dynamic"), tr("Dynamic friction"), tr("Dynamic"));
  auto* rows = new QVBoxLayout(details_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  rows->addWidget(static_);
  rows->addWidget(dynamic_);
  // One takes the other along: the dynamic share is never above the static one.
  connect(static_, &ValueRow::changed, this, [this](double share, bool fresh) {
    emit frictionChanged(scene::Friction{share, std::min(share, shown_.dynamic_share)}, settingLabel(kStatic), fresh);
  });
  connect(dynamic_, &ValueRow::changed, this, [this](double share, bool fresh) {
    emit frictionChanged(scene::Friction{std::max(share, shown_.static_share), share}, settingLabel(kDynamic), fresh);
  });
}

std::optional<scene::Friction> SurfaceSection::switched(bool on) const {
  return on ? std::optional(shown_) : std::nullopt;
}

void SurfaceSection::begin(const std::optional<scene::Friction>& own) {
  shown_ = own.value_or(kWood);
}

bool SurfaceSection::isHeld() const {
  return static_->isHeld() || dynamic_->isHeld() || smooth_->isHeld();
}

void SurfaceSection::present(const SurfaceValues& now, const SurfaceValues& own) {
  if (now.friction) shown_ = *now.friction;
  const QSignalBlocker silent_on(on_), silent_search(search_);  // to show a value is not to ask for it
  on_->setChecked(now.friction.has_value());
  details_->setVisible(now.friction.has_value());
  static_->present(shown_.static_share, own.friction ? std::optional(own.friction->static_share) : std::nullopt);
  dynamic_->present(shown_.dynamic_share, own.friction ? std::optional(own.friction->dynamic_share) : std::nullopt);
  smooth_->setVisible(now.smooth_deg.has_value());
  if (now.smooth_deg) smooth_->present(*now.smooth_deg, own.smooth_deg);
  search_line_->setVisible(now.search.has_value());
  if (now.search) search_->setCurrentIndex(static_cast<int>(*now.search));
}

}  // namespace underact::gui
