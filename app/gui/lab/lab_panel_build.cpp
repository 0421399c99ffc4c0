// How the Lab panel is put together; what it does is in lab_panel.cpp.
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/told_label.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/lab/choice_list.h"
#include "app/gui/lab/front_chart.h"
#include "app/gui/lab/lab_panel.h"
#include "core/sim/hand_script.h"

namespace underact::gui {
namespace {

constexpr int kProgressSteps = 1000;
constexpr int kLookForRun_ms = 50;

}  // namespace

void LabPanel::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  buildMeasuring(column);
  buildWalk(column);
  column->addWidget(sectionTitle(tr("What this scene offers"), content));
  column->addWidget(tick_ = toldLabel("panel.lab.tick", tr("What a tick is predicted to take"), "quiet", content));
  column->addSpacing(4);
  column->addWidget(choices_ = new ChoiceList(content));
  column->addStretch(1);
  fillWithScroll(this, content);
  looks_.setInterval(kLookForRun_ms);
}

void LabPanel::buildMeasuring(QVBoxLayout* column) {
  hands_ = chooser("panel.lab.hands", tr("Hands that hold the stylus"),
                   tr("Who moves the simulated stylus while it is measured."), this);
  hands_->addItem(tr("All hands"), "");
  for (const sim::BuiltInHand& one : sim::builtInHands()) hands_->addItem(one.name, one.name);
  seconds_ = new QSpinBox(this);
  seconds_->setObjectName("panel.lab.seconds");
  seconds_->setAccessibleName(tr("Length of each run, s"));
  seconds_->setToolTip(tr("How long each run is, in the time of the simulated arm."));
  seconds_->setRange(2, 4);
  seconds_->setSuffix(tr(" s each"));
  seconds_->setFocusPolicy(Qt::StrongFocus);
  measure_ = pushButton("panel.lab.measure", tr("&Measure"),
                        tr("Measures cost and error of every choice, and the front of all ways to run this scene."),
                        this, tr("Measure speed and accuracy of this scene"));
  cancel_ = pushButton("panel.lab.cancel", tr("Cancel"), tr("Ends the measurement; nothing is kept."), this,
                       tr("Cancel the measurement"));
  progress_ = new QProgressBar(this);
  progress_->setObjectName("panel.lab.progress");
  progress_->setAccessibleName(tr("Progress of the measurement"));
  progress_->setRange(0, kProgressSteps);
  told_ = toldLabel("panel.lab.told", tr("What there is to know of the measurement"), "quiet", this);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Hands"), hands_);
  form->addRow(tr("R&uns"), seconds_);
  auto* row = new QHBoxLayout;
  row->addWidget(measure_, 1);
  row->addWidget(cancel_);
  column->addLayout(form);
  column->addLayout(row);
  column->addWidget(progress_);
  column->addWidget(told_);
  connect(measure_, &QPushButton::clicked, this,
          [this] { measure(hands_->currentData().toString().toStdString(), seconds_->value()); });
  connect(cancel_, &QPushButton::clicked, this, &LabPanel::cancel);
  const auto tellAnew = [this] {
    if (run_ == nullptr && result_.standings.empty()) tell(whatMeasuringDoes(), false);
  };
  connect(hands_, &QComboBox::currentIndexChanged, this, tellAnew);
  connect(seconds_, &QSpinBox::valueChanged, this, tellAnew);
}

void LabPanel::buildWalk(QVBoxLayout* column) {
  column->addWidget(chart_ = frontChart(this));
  walk_ = new MarkedSlider(this);
  walk_->setObjectName("panel.lab.walk");
  walk_->setAccessibleName(tr("From speed to accuracy"));
  walk_->setToolTip(
      tr("Along the front: from the cheapest way to run this scene to the most exact. The mark is how it "
         "was; a double click goes back there."));
  walk_->setPageStep(1);
  walk_->setTickInterval(1);
  auto* speed = new QLabel(tr("S&peed"), this);
  speed->setBuddy(walk_);
  auto* ends = new QHBoxLayout;
  ends->addWidget(speed);
  ends->addWidget(walk_, 1);
  ends->addWidget(new QLabel(tr("Accuracy"), this));
  column->addLayout(ends);
  chosen_ = toldLabel("panel.lab.chosen", tr("What is chosen"), "quiet", this);
  differences_ = toldLabel("panel.lab.differences", tr("What differs from how the scene was"), "", this);
  back_ = pushButton("panel.lab.back", tr("As it &was"),
                     tr("Puts scene and servo rate back to how they were when they were measured."), this,
                     tr("As it was when it was measured"));
  column->addWidget(chosen_);
  column->addWidget(differences_);
  column->addWidget(back_, 0, Qt::AlignLeft);
  connectWalk();
}

void LabPanel::connectWalk() {
  constexpr int kPauseBetweenSteps_ms = 1000;  // a run of keys or wheel steps is over after so long
  connect(walk_, &QSlider::sliderPressed, this, &LabPanel::beginGesture);
  connect(walk_, &QSlider::valueChanged, this, [this](int stop) {
    const bool is_dragged = walk_->isSliderDown();
    if (!is_dragged && (!since_step_.isValid() || since_step_.elapsed() > kPauseBetweenSteps_ms)) beginGesture();
    since_step_.start();
    walkTo(stop, !is_dragged);
  });
  connect(walk_, &QSlider::sliderReleased, this, [this] { walkTo(walk_->value(), true); });
  connect(walk_, &MarkedSlider::resetAsked, this, &LabPanel::putBack);
  connect(back_, &QPushButton::clicked, this, &LabPanel::putBack);
}

void LabPanel::addCommands() {
  parts_.actions.addCommand("lab.measure", [this](const QVariantList& values) {  // hand ("" for all), seconds
    const QString hand = values.isEmpty() ? hands_->currentData().toString() : values[0].toString();
    return measure(hand.toStdString(), values.size() < 2 ? seconds_->value() : values[1].toDouble());
  });
  parts_.actions.addCommand("lab.cancel", [this](const QVariantList&) { return cancel(); });
  parts_.actions.addCommand("lab.walk", [this](const QVariantList& values) {  // a stop, or a share from 0 to 1
    if (values.size() != 1 || front_.empty()) return false;
    beginGesture();
    const bool is_share = values[0].typeId() == QMetaType::Double;
    const double share = values[0].toDouble();
    if (is_share && !(share >= 0.0 && share <= 1.0)) return false;
    return walkTo(is_share ? qRound(share * static_cast<double>(front_.size() - 1)) : values[0].toInt(), true);
  });
  parts_.actions.addCommand("lab.back", [this](const QVariantList&) { return putBack(); });
}

}  // namespace underact::gui
