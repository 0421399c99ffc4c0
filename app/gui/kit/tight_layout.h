#pragma once
#include <QLayout>

namespace underact::gui {

/// A layout without margins, for a widget inside another's layout. spacing: logical pixels; -1: the style's.
template <class Layout>
Layout* tight(QWidget* widget, int spacing = -1) {
  auto* const layout = new Layout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

}  // namespace underact::gui
