#include "app/gui/kit/focus_style.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QPainter>
#include <QSlider>
#include <QStyleOption>

#include "app/gui/kit/contrast.h"
#include "app/gui/kit/flat_forms.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/theme.h"

namespace underact::gui {
namespace {

void drawRing(const QStyleOption& option, const QRectF& place, QPainter& painter) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(focusColour(option.palette), 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(place.adjusted(0.75, 0.75, -0.75, -0.75), 2, 2);
  painter.restore();
}

/// A click needs no ring to show where the focus is.
bool hasKeys(const QStyleOption& option) {
  return option.state.testFlag(QStyle::State_HasFocus) && option.state.testFlag(QStyle::State_KeyboardFocusChange);
}

/// Over the style's own outline, which is too close to its ground: the lines of Fusion are darker than the window, also
/// where that is dark.
void drawOutline(const QStyleOption& option, const QRectF& place, double radius, QPainter& painter) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, radius > 0.0);
  painter.setPen(outlinePen(option));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
  painter.restore();
}

/// As Fusion draws it.
void drawRadioOutline(const QStyleOption& option, QPainter& painter) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(outlinePen(option));
  painter.setBrush(Qt::NoBrush);
  const double radius = (option.rect.width() + (option.rect.width() + 1) % 2) / 2.0 - 1.0;
  painter.drawEllipse(QPointF(option.rect.center() + QPoint(1, 1)), radius, radius);
  painter.restore();
}

}  // namespace

void FocusStyle::polish(QApplication* application) {
  QProxyStyle::polish(application);
  connect(application, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { frame(now); });
}

void FocusStyle::frame(QWidget* focused) {
  const bool by_keys = focused != nullptr && focused->window()->testAttribute(Qt::WA_KeyboardFocusChange);
  if (!by_keys || focused->isWindow() || qobject_cast<QAbstractScrollArea*>(focused) == nullptr) {
    delete frame_;
    return;
  }
  if (frame_ == nullptr) frame_ = new QFocusFrame(focused);
  frame_->setWidget(focused);
}

void FocusStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  if (element == PE_IndicatorDockWidgetResizeHandle) {
    const bool is_under = option->state.testFlag(State_MouseOver);
    const QColor line =
        mixed(option->palette.color(QPalette::Window), option->palette.color(QPalette::WindowText), 0.16);
    return painter->fillRect(option->rect, is_under ? focusColour(option->palette) : line);
  }
  const auto* const button = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (element == PE_IndicatorCheckBox) return drawCheckBox(*option, *painter);
  if (element == PE_PanelButtonCommand && button != nullptr && !button->features.testFlag(QStyleOptionButton::Flat))
    return drawFlatButton(*button, *painter);
  if (element != PE_FrameFocusRect) QProxyStyle::drawPrimitive(element, option, painter, widget);
  const bool has_focus = option->state.testFlag(State_HasFocus);
  if (element == PE_IndicatorRadioButton) drawRadioOutline(*option, *painter);
  if (element == PE_FrameLineEdit && !has_focus) drawOutline(*option, option->rect, 2.0, *painter);
  if (element == PE_PanelMenu || element == PE_FrameMenu) {
    QStyleOption edge = *option;
    edge.state |= State_Enabled;  // menus do not say what they are
    drawOutline(edge, option->rect, 0.0, *painter);
  }
  const bool is_field = element == PE_FrameLineEdit && hasKeys(*option);
  const bool is_ring = element == PE_FrameFocusRect && option->state.testFlag(State_KeyboardFocusChange);
  if (is_field || is_ring) drawRing(*option, option->rect, *painter);
}

void FocusStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
  if (element == CE_FocusFrame) {
    // On the edge of the widget, not beyond, where the panel's edge would clip it.
    const int across = pixelMetric(PM_FocusFrameHMargin, option, widget);
    const int down = pixelMetric(PM_FocusFrameVMargin, option, widget);
    return drawRing(*option, option->rect.adjusted(across, down, -across, -down), *painter);
  }
  QProxyStyle::drawControl(element, option, painter, widget);
  if (element == CE_PushButtonBevel && hasKeys(*option)) drawRing(*option, option->rect, *painter);
}

void FocusStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const {
  const auto* const slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control == CC_ScrollBar && slider != nullptr)
    return drawScrollBar(*slider, subControlRect(control, option, SC_ScrollBarSlider, widget), *painter);
  if (control == CC_Slider && slider != nullptr && slider->tickPosition == QSlider::NoTicks) {
    drawSlider(*slider, subControlRect(control, option, SC_SliderGroove, widget),
               subControlRect(control, option, SC_SliderHandle, widget), *painter);
  } else {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
  }
  if (control == CC_SpinBox && !option->state.testFlag(State_HasFocus))
    drawOutline(*option, option->rect, 2.0, *painter);
  const bool is_ours = control == CC_ComboBox || control == CC_SpinBox || control == CC_Slider;
  if (is_ours && hasKeys(*option)) drawRing(*option, option->rect, *painter);
}

QRect FocusStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                 const QWidget* widget) const {
  const auto* const bar = control == CC_ScrollBar ? qstyleoption_cast<const QStyleOptionSlider*>(option) : nullptr;
  return bar == nullptr ? QProxyStyle::subControlRect(control, option, part, widget)
                        : partOfScrollBar(*bar, part, pixelMetric(PM_ScrollBarSliderMin, option, widget));
}

int FocusStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* more) const {
  if (hint == SH_FocusFrame_AboveWidget) return 1;
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;  // they would be of another set
  if (hint == SH_FocusFrame_Mask) return 0;                   // a mask would leave only the part beyond the edge
  return QProxyStyle::styleHint(hint, option, widget, more);
}

QIcon FocusStyle::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
  const QPalette palette = widget != nullptr ? widget->palette() : QApplication::palette();
  const QColor ground = palette.color(QPalette::Window), ink = palette.color(QPalette::WindowText);
  const Theme theme = luminanceOf(ground) < luminanceOf(ink) ? Theme::dark_theme() : Theme::light();
  switch (which) {
    case SP_MessageBoxQuestion:
      return icon("question", theme);
    case SP_MessageBoxInformation:
      return icon("information", theme);
    case SP_MessageBoxWarning:
      return icon("warning", theme);
    case SP_MessageBoxCritical:
      return icon("critical", theme);
    default:
      return QProxyStyle::standardIcon(which, option, widget);
  }
}

int FocusStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  if (metric == PM_DockWidgetSeparatorExtent) return 1;
  if (metric == PM_ScrollBarExtent) return 12;
  if (widget != nullptr && widget->inherits("QMessageBox")) {
    if (metric == PM_LayoutBottomMargin || metric == PM_LayoutHorizontalSpacing) return 16;
    if (metric == PM_LayoutLeftMargin || metric == PM_LayoutTopMargin || metric == PM_LayoutRightMargin) return 20;
  }
  return QProxyStyle::pixelMetric(metric, option, widget);
}

}  // namespace underact::gui
