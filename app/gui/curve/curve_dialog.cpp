#include "app/gui/curve/curve_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "core/mesh_file/report.h"

namespace underact::gui {
namespace {

constexpr double kMinScale = 1e-6, kMaxScale = 1e6;  // mm per unit; a scene file may have more
constexpr int kScaleDecimals = 6;

/// "25.4 mm", without trailing zeros.
class ScaleField : public NumberBox {
 public:
  using NumberBox::NumberBox;
  QString textFromValue(double value) const override { return locale().toString(value, 'g', 12); }
};

}  // namespace

CurveDialog::CurveDialog(const QString& path, std::shared_ptr<const std::vector<Vec3>> points, bool can_add,
                         QWidget* parent)
    : AddDialog("dialog.curve", tr("Curve %1"), path, tr("Size of the curve"), parent),
      points_(std::move(points)),
      low_(points_->front()),
      high_(low_) {
  Vec3 last = low_;
  for (const Vec3& p : *points_) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
    length_m_ += (p - last).norm();
    last = p;
  }
  buildChoices();
  proposeUnit();
  layFoot(can_add, tr("Adds the curve to the current scene."), tr("Opens a new scene with only this curve."));
  refresh();
  resize(QSize(64 * fontMetrics().averageCharWidth(), sizeHint().height()));
}

void CurveDialog::buildChoices() {
  kind_ = new QComboBox(this);
  kind_->setObjectName("dialog.curve.kind");
  kind_->setAccessibleName(tr("Interpolation between the points"));
  kind_->addItem(tr("smooth (spline)"), static_cast<int>(curve::CurveKind::Spline));
  kind_->addItem(tr("straight lines (polyline)"), static_cast<int>(curve::CurveKind::Polyline));
  closed_ = new QCheckBox(tr("C&losed: from the last point back to the first"), this);
  closed_->setObjectName("dialog.curve.closed");
  closed_->setAccessibleName(tr("Closed"));
  scale_ = new ScaleField(this);
  scale_->setObjectName("dialog.curve.scale");
  scale_->setAccessibleName(tr("Millimetres per file unit"));
  scale_->setToolTip(tr("Length of one file unit: 1 for mm, 1000 for m, 25.4 for inches."));
  scale_->setDecimals(kScaleDecimals);
  scale_->setRange(kMinScale, kMaxScale);
  scale_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  scale_->setValue(1.0);
  scale_->setSuffix(tr(" mm"));
  auto* rows = new QFormLayout;
  rows->setSpacing(8);
  rows->addRow(tr("&Interpolation"), kind_);
  rows->addRow(tr("Ends"), closed_);
  rows->addRow(tr("File &unit"), scale_);
  column()->addLayout(rows);
  connect(scale_, &QDoubleSpinBox::valueChanged, this, &CurveDialog::refresh);
  connect(closed_, &QCheckBox::toggled, this, &CurveDialog::refresh);
}

// A file does not state its unit: if millimetres give an implausible size, the most likely other unit is set.
void CurveDialog::proposeUnit() {
  const double largest = (high_ - low_).maxCoeff();
  const auto proposal = mesh_file::implausible(largest);
  if (!proposal || !(largest > 0.0)) return;
  QLabel* told = messageLabel("dialog.curve.question", tr("Which unit"), "amber", this);
  const QString as_mm = tr("In millimetres the curve would be %1 long.").arg(millimetres(largest));
  told->setText(tr("%1 Which unit is the file in?").arg(as_mm));
  if (!proposal->units.empty()) {
    const mesh_file::Unit& likeliest = proposal->units.front();
    scale_->setValue(likeliest.mm_per_unit);
    told->setText(
        tr("%1 It is assumed to be in %2.").arg(as_mm, QCoreApplication::translate("problem", likeliest.name)));
  }
  column()->addWidget(told);
}

void CurveDialog::refresh() {
  const double scale = scale_->value();
  const double length_m = length_m_ + (closed_->isChecked() ? (points_->front() - points_->back()).norm() : 0.0);
  counts()->setText(tr("%1 points, %2, length %3.")
                        .arg(points_->size())
                        .arg(placeText(scale * (high_ - low_)).replace(", ", " × "), millimetres(scale * length_m)));
}

scene::Constraint CurveDialog::constraint() const {
  scene::Curve curve;
  curve.kind = static_cast<curve::CurveKind>(kind_->currentData().toInt());
  curve.closed = closed_->isChecked();
  curve.points = points_;
  return fromFile(std::move(curve), scale_->value(), 0.5 * (low_ + high_));
}

}  // namespace underact::gui
