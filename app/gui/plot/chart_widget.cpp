#include "app/gui/plot/chart_widget.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/plot/chart.h"
#include "app/gui/view/gl_surface.h"

namespace underact::gui {

ChartWidget::ChartWidget(QWidget* parent)
    : QWidget(parent),
      surface_(new GlSurface([this](QSize pixels) { before(pixels); },
                             [this](QPainter& painter) {
                               for (const Chart* chart : shown()) chart->paintWords(painter);
                             },
                             this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(surface_);
}

ChartWidget::~ChartWidget() {
  delete surface_;
}

void ChartWidget::hold(std::span<Chart* const> charts) {
  const vtkNew<vtkContextActor> actor;
  for (const Chart* chart : charts) actor->GetScene()->AddItem(chart->item());
  surface_->renderer().AddActor(actor);
  actor->GetScene()->SetRenderer(&surface_->renderer());
}

void ChartWidget::before(QSize pixels) {
  const bool places = pixels != placed_;
  placed_ = pixels;
  if (places) place(pixels.height() / std::max(1.0, static_cast<double>(height())));
  prepare(places);
}

QImage ChartWidget::picture() {
  if (surface_->size() != size()) surface_->setGeometry(rect());  // never shown: no layout has been at work
  return surface_->picture();
}

void ChartWidget::setBackground(const Theme& theme) {
  surface_->setBackground(theme.background);
}

void ChartWidget::draw() {
  surface_->update();
}

void ChartWidget::placeAnew() {
  placed_ = {};
  draw();
}

void ChartWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) placeAnew();
}

}  // namespace underact::gui
