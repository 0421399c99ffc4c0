#include "app/gui/plots/plots_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/feature/parts.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"
#include "app/gui/model/settings.h"
#include "app/gui/plot/column_button.h"
#include "app/gui/plot/live_plot.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {

PlotsPanel::PlotsPanel(const Parts& parts, QWidget* parent)
    : Panel(parent),
      player_(parts.player),
      plot_(new LivePlot(this)),
      axis_(new QComboBox(this)),
      energy_(new QCheckBox(tr("Ener&gy"), this)),
      hold_(new QCheckBox(tr("Freeze"), this)),
      columns_(new ColumnButton("panel.plots.columns", this)) {
  nameWidget(hold_, "panel.plots.hold", tr("Freeze the plots"),
             tr("Freezes the plots so that you can read and enlarge them. The servo keeps running."));
  nameWidget(plot_, "panel.plots.plot", tr("Error and force over the last 10 s, and force against displacement"));
  plot_->setMinimumHeight(96);
  nameWidget(
      axis_, "panel.plots.axis", tr("Axis of force against displacement"),
      tr("Axis of the workspace frame W along which force is plotted against displacement (thesis figure 4.3)."));
  axis_->addItems({tr("x"), tr("y"), tr("z")});
  axis_->setFocusPolicy(Qt::StrongFocus);
  nameWidget(energy_, "panel.plots.energy", tr("Energy plot"),
             tr("The energy that the stylus has put into the constraints and not received back, E = Σ −f·Δp. Below "
                "zero they have given out more than they received: they are active."));
  auto* label = new QLabel(tr("Force against &displacement, axis"), this);
  label->setProperty("role", "quiet");
  label->setBuddy(axis_);
  auto* strip = new QHBoxLayout;
  strip->setContentsMargins(12, 4, 12, 0);
  strip->setSpacing(8);
  strip->addWidget(energy_);
  strip->addWidget(hold_);
  strip->addWidget(columns_);
  strip->addStretch(1);
  strip->addWidget(label);
  strip->addWidget(axis_);
  auto* column = tight<QVBoxLayout>(this, 0);
  column->addLayout(strip);
  column->addWidget(plot_, 1);
  connect(axis_, &QComboBox::currentIndexChanged, plot_, &LivePlot::setAxis);
  connect(plot_, &LivePlot::pathShown, this, [this, label, tip = axis_->toolTip()](bool shown) {
    axis_->setEnabled(shown);
    label->setEnabled(shown);
    axis_->setToolTip(
        shown ? tip : tr("There is not enough room for this plot: switch Energy off, or make the window wider."));
  });
  connect(energy_, &QCheckBox::toggled, plot_, &LivePlot::showEnergy);
  connect(hold_, &QCheckBox::toggled, plot_, &LivePlot::hold);
  connect(columns_, &ColumnButton::changed, this, [this] { plot_->showColumns(columns_->chosen()); });
  parts.actions.addCommand("plots.hold", [this](const QVariantList& on) {
    hold_->setChecked(on.value(0).toBool());
    return true;
  });
  parts.actions.addCommand("plots.columns", [this](const QVariantList& names) {
    QStringList wanted;
    for (const QVariant& name : names) wanted << name.toString();
    columns_->choose(wanted);
    return columns_->names().size() == wanted.size();
  });
  const auto showAngles = [this, &document = parts.document] {
    const std::vector<scene::Constraint>& held = document.scene().constraints;
    plot_->showAngles(std::any_of(held.begin(), held.end(), [](const scene::Constraint& constraint) {
      return constraint.influence.has_value();
    }));
  };
  connect(&parts.document, &Document::edited, this, showAngles);
  connect(&parts.document, &Document::opened, this, showAngles);
  connect(&parts.document, &Document::opened, this, [this, &document = parts.document] {
    plot_->clear();
    const arm::Preset& arm = scene::armOf(document.scene());
    plot_->setForceLimit(arm.continuous_force_N);
    plot_->setGeometry(arm.geometry);
  });
  parts.actions.addCommand("plots.energy", [this](const QVariantList& on) {
    energy_->setChecked(on.value(0).toBool());
    return true;
  });
  parts.actions.addCommand("plots.axis", [this](const QVariantList& values) {
    const auto axis = static_cast<int>(QStringList{"x", "y", "z"}.indexOf(values.value(0).toString()));
    if (axis >= 0) axis_->setCurrentIndex(axis);
    return axis >= 0;
  });
  axis_->setCurrentIndex(parts.settings.plot_axis);
  energy_->setChecked(parts.settings.energy_plot);
  plot_->showEnergy(parts.settings.energy_plot);
}

void PlotsPanel::present(const servo::Snapshot&) {
  if (isVisible() && ++frame_ % kFramesAPlot == 0) plot_->redraw();
}

void PlotsPanel::add(const servo::TickRecord& record) {
  plot_->add(record, player_.beside());
}

void PlotsPanel::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

void PlotsPanel::remember(Settings& settings) {
  settings.plot_axis = plot_->axis();
  settings.energy_plot = plot_->showsEnergy();
}

}  // namespace underact::gui
