#include "app/gui/feel/rate_section.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <optional>
#include <utility>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/section.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/model/setting_words.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

constexpr const char* kFilter = "/control/velocity/filter";
constexpr std::array kPassivities{control::Passivity::Off, control::Passivity::Observe, control::Passivity::Control};

/// The main setting of a filter, or null.
double* mainSetting(scene::Velocity& velocity) {
  if (auto* kalman = std::get_if<scene::KalmanFilter>(&velocity)) return &kalman->acceleration_mm_per_s2;
  if (auto* low_pass = std::get_if<scene::LowPassFilter>(&velocity)) return &low_pass->time_constant_ms;
  if (auto* adaptive = std::get_if<scene::AdaptiveWindowFilter>(&velocity)) return &adaptive->window;
  return nullptr;
}

}  // namespace

RateSection::RateSection(QWidget* parent)
    : QWidget(parent),
      section_(new Section(
          "rate", tr("Rate and energy"),
          tr("How the rate of the error is found, for damping, and whether the energy of the constraint is watched."),
          this, "feel")),
      choices_(new QFormLayout) {
  setObjectName("panel.rate");
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(section_);
  filter_ = chooser("panel.rate.filter", tr("Velocity filter"), settingTip(kFilter), this);
  filter_->addItems({tr("Kalman"), tr("low-pass"), tr("adaptive window"), tr("raw difference")});
  passivity_ = chooser("panel.rate.passivity", tr("Passivity"), settingTip("/control/passivity"), this);
  passivity_->addItems({tr("off"), tr("observe"), tr("control")});
  choices_->setHorizontalSpacing(12);
  choices_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  choices_->addRow(tr("&Velocity"), filter_);
  buildRows();
  choices_->addRow(tr("&Passivity"), passivity_);
  section_->column().addLayout(choices_);
  section_->findChild<QToolButton*>("panel.feel.rate.fold")->setChecked(false);
  connect(filter_, &QComboBox::currentIndexChanged, this, [this](int row) {
    emit asked(kFilter, scene::findSetting(kFilter)->words()[static_cast<std::size_t>(row)], true);
  });
  connect(passivity_, &QComboBox::currentIndexChanged, this, [this](int row) {
    const control::Passivity wanted = kPassivities[static_cast<std::size_t>(row)];
    emit asked("/control/passivity", std::string(wordOf(scene::kPassivityWords, wanted)), true);
  });
}

void RateSection::buildRows() {
  const auto add = [this](std::size_t filter, const std::string& key, const ValueKind& kind, const QString& name,
                          const QString& label) {
    auto* row = new ValueRow(kind, name, this);
    row->setLabel(tr("Setting"), label, tr("Setting"));
    connect(row, &ValueRow::changed, this,
            [this, key](double value, bool fresh) { emit asked("/control/velocity/" + key, value, fresh); });
    choices_->addRow(row);
    settings_[filter] = row;
  };
  add(0, "acceleration_mm_per_s2",
      {settingTip("/control/velocity/acceleration_mm_per_s2"), tr("mm/s²"), 1, 30000, 0, 100000.0},
      "panel.rate.acceleration", tr("Acceleration"));
  add(1, "time_constant_ms", {settingTip("/control/velocity/time_constant_ms"), tr("ms"), 10, 200, 1, 1000.0},
      "panel.rate.time_constant", tr("Time constant"));
  add(2, "window", {settingTip("/control/velocity/window"), tr("ticks"), 1, 32, 0, 32.0}, "panel.rate.window",
      tr("Longest window"));
}

bool RateSection::isHeld() const {
  for (const ValueRow* row : settings_) {
    if (row != nullptr && row->isHeld()) return true;
  }
  return false;
}

void RateSection::present(const scene::Control& now, const scene::Control& own) {
  shown_ = now.velocity;
  const QSignalBlocker silent_filter(filter_), silent_passivity(passivity_);  // to show a value is not to ask for it
  const bool has_rate = now.law != scene::LawType::P;
  filter_->setCurrentIndex(static_cast<int>(shown_.index()));
  choices_->setRowVisible(filter_, has_rate);
  for (std::size_t filter = 0; filter < settings_.size(); ++filter) {
    ValueRow* const row = settings_[filter];
    if (row == nullptr) continue;
    choices_->setRowVisible(row, has_rate && filter == shown_.index());
    if (filter != shown_.index()) continue;
    scene::Velocity file = own.velocity;
    const bool same_filter = own.velocity.index() == shown_.index();
    row->present(*mainSetting(shown_), same_filter ? std::optional(*mainSetting(file)) : std::nullopt);
  }
  for (std::size_t row = 0; row < kPassivities.size(); ++row) {
    if (kPassivities[row] == now.passivity) passivity_->setCurrentIndex(static_cast<int>(row));
  }
}

}  // namespace underact::gui
