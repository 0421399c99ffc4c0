#include "app/gui/mesh/section_strip.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

constexpr int kStepsPerMillimetre = 10;  // of the slider; arrows move 1 mm, Page keys 10 mm

}  // namespace

SectionStrip::SectionStrip(SceneView& view, Actions& actions, QWidget* parent)
    : QWidget(parent), view_(view), actions_(actions), slider_(new MarkedSlider(this)), number_(new NumberBox(this)) {
  setObjectName("section");
  setAccessibleName(tr("Cut"));
  addActions();
  build();
  hide();
}

void SectionStrip::build() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 12, 4);
  row->setSpacing(8);
  row->addWidget(new QLabel(tr("Cut across"), this));
  const auto button = [&](const char* action, const QString& spoken) {
    auto* made = new QToolButton(this);
    made->setDefaultAction(actions_.find(action));
    made->setObjectName(QString("section.button.") + action);
    made->setAccessibleName(spoken);
    made->setProperty("role", "choice");
    made->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(made);
  };
  button("section.x", tr("Cut across x"));
  button("section.y", tr("Cut across y"));
  button("section.z", tr("Cut across z"));
  slider_->setObjectName("section.slider");
  slider_->setAccessibleName(tr("Position of the cut"));
  slider_->setToolTip(tr("Position of the cut along its axis. Double-click to let it follow the stylus again."));
  slider_->setMark(-1e9);  // no mark: a cut has no default position
  slider_->setMinimumWidth(16 * fontMetrics().averageCharWidth());
  slider_->setSingleStep(kStepsPerMillimetre);
  slider_->setPageStep(10 * kStepsPerMillimetre);
  number_->setObjectName("section.number");
  number_->setAccessibleName(tr("Position of the cut"));
  number_->setSuffix(tr(" mm"));
  number_->setDecimals(1);
  number_->setKeyboardTracking(false);  // only complete numbers move the cut
  row->addWidget(slider_, 1);
  row->addWidget(number_);
  button("layer.section_follows", tr("The cut follows the stylus"));
  connect(slider_, &QSlider::valueChanged, this, [this](int step) { put(double(step) / kStepsPerMillimetre); });
  connect(number_, &QDoubleSpinBox::valueChanged, this, &SectionStrip::put);
  connect(slider_, &MarkedSlider::resetAsked, this, [this] { actions_.perform("layer.section_follows", true); });
}

void SectionStrip::addActions() {
  actions_.add({"section.move", tr("Move the cut with the ke&ys"), QKeySequence("Alt+M"),
                tr("Moves the focus to the slider of the cut: the arrow keys then move the cut by 1 mm, Page Up and "
                   "Page Down by 10 mm.")},
               [this](const QVariantList&) {
                 actions_.perform("layer.section", true);
                 follow();
                 slider_->setFocus(Qt::ShortcutFocusReason);
                 return hasCut();
               });
  actions_.addCommand("section.place", [this](const QVariantList& at_mm) {
    return at_mm.size() == 1 && std::isfinite(at_mm.first().toDouble()) && put(at_mm.first().toDouble());
  });
}

bool SectionStrip::hasCut() const {
  return view_.layers().section && view_.trianglesDrawn() > 0;
}

bool SectionStrip::put(double at_mm) {
  const auto [min_mm, max_mm] = view_.sectionRange_mm(view_.layers().section_axis);
  if (at_mm < min_mm || at_mm > max_mm) return false;
  actions_.perform("layer.section_follows", false);
  Layers layers = view_.layers();
  layers.section_mm[layers.section_axis] = at_mm;
  view_.setLayers(layers);
  return true;
}

void SectionStrip::follow() {
  if (isVisibleTo(parentWidget()) != hasCut()) setVisible(hasCut());
  if (!hasCut()) return;
  const Layers& layers = view_.layers();
  const auto [min_mm, max_mm] = view_.sectionRange_mm(layers.section_axis);
  const double at_mm = std::clamp(layers.section_mm[layers.section_axis], min_mm, max_mm);
  const QSignalBlocker silent_slider(slider_), silent_number(number_);  // showing a value must not set it
  slider_->setRange(static_cast<int>(std::ceil(kStepsPerMillimetre * min_mm)),
                    static_cast<int>(std::floor(kStepsPerMillimetre * max_mm)));
  number_->setRange(slider_->minimum() / double(kStepsPerMillimetre), slider_->maximum() / double(kStepsPerMillimetre));
  if (!slider_->isSliderDown()) slider_->setValue(static_cast<int>(std::lround(kStepsPerMillimetre * at_mm)));
  if (!number_->hasFocus() || layers.section_follows) number_->setValue(at_mm);
}

}  // namespace underact::gui
