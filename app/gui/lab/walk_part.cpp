#include "app/gui/lab/walk_part.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/lab/front_chart.h"

namespace underact::gui {
namespace {

/// The most expensive stop that costs no more than the point.
int stopBefore(const std::vector<std::size_t>& front, std::size_t point) {
  const auto dearer = std::upper_bound(front.begin(), front.end(), point);  // points are sorted by cost
  return std::max(0, static_cast<int>(dearer - front.begin()) - 1);
}

}  // namespace

WalkPart::WalkPart(QWidget* parent) : QWidget(parent) {
  auto* column = tight<QVBoxLayout>(this, 4);
  column->addWidget(chart_ = frontChart(this));
  walk_ = new MarkedSlider(this);
  walk_->setObjectName("panel.lab.walk");
  walk_->setAccessibleName(tr("From speed to accuracy"));
  walk_->setToolTip(
      tr("Moves along the best trade-offs, from the fastest to the most accurate. The mark shows the scene as "
         "measured; a double click returns to it."));
  walk_->setPageStep(1);
  walk_->setTickInterval(1);
  auto* speed = new QLabel(tr("S&peed"), this);
  speed->setBuddy(walk_);
  auto* ends = new QHBoxLayout;
  ends->addWidget(speed);
  ends->addWidget(walk_, 1);
  ends->addWidget(new QLabel(tr("Accuracy"), this));
  column->addLayout(ends);
  chosen_ = messageLabel("panel.lab.chosen", tr("Chosen combination"), "quiet", this);
  differences_ = messageLabel("panel.lab.differences", tr("Differences from the scene as it was"), "", this);
  back_ = pushButton("panel.lab.back", tr("&Restore"), tr("Restores the scene and the servo rate that were measured."),
                     this, tr("Restore what was measured"));
  column->addWidget(chosen_);
  column->addWidget(differences_);
  column->addWidget(back_, 0, Qt::AlignLeft);
  connectSlider();
}

void WalkPart::connectSlider() {
  constexpr int kPauseBetweenSteps_ms = 1000;  // a run of keys or wheel steps is over after so long
  const auto begin = [this] {
    since_step_.start();
    emit begun();
  };
  connect(walk_, &QSlider::sliderPressed, this, begin);
  connect(walk_, &QSlider::valueChanged, this, [this, begin](int stop) {
    const bool is_dragged = walk_->isSliderDown();
    if (!is_dragged && (!since_step_.isValid() || since_step_.elapsed() > kPauseBetweenSteps_ms)) begin();
    since_step_.start();
    emit stopAsked(stop, !is_dragged);
  });
  connect(walk_, &QSlider::sliderReleased, this, [this] { emit stopAsked(walk_->value(), true); });
  connect(walk_, &MarkedSlider::resetAsked, this, &WalkPart::backAsked);
  connect(back_, &QPushButton::clicked, this, &WalkPart::backAsked);
}

void WalkPart::setTheme(const Theme& theme) {
  chart_->setTheme(theme);
}

void WalkPart::setStop(int stop) {
  const QSignalBlocker silent(walk_);
  walk_->setValue(stop);
}

std::optional<std::size_t> WalkPart::present(const std::vector<tradeoff::Point>& points,
                                             const std::vector<std::size_t>& front, std::optional<std::size_t> now,
                                             bool is_measured) {
  const bool has_front = !front.empty();
  chart_->setVisible(is_measured && !points.empty());
  walk_->setEnabled(has_front);
  back_->setEnabled(has_front);
  const QSignalBlocker silent(walk_);
  walk_->setRange(0, std::max(0, static_cast<int>(front.size()) - 1));
  differences_->setVisible(has_front);
  if (!has_front) {
    walk_->setMark(-1.0);
    chosen_->setText(tr("There is nothing to choose from yet."));
    chart_->present(frontSheet({}, {}));
    return {};
  }
  const auto own = std::find_if(front.begin(), front.end(), [&](std::size_t point) { return points[point].is_own; });
  walk_->setMark(own == front.end() ? -1.0 : static_cast<double>(own - front.begin()));
  if (walk_->isSliderDown())
    now = front[static_cast<std::size_t>(walk_->value())];
  else if (now)
    walk_->setValue(stopBefore(front, *now));
  chart_->present(frontSheet(points, now));
  return now;
}

void WalkPart::tell(const QString& chosen, const QString& differences) {
  chosen_->setText(chosen);
  differences_->setText(differences);
}

}  // namespace underact::gui
