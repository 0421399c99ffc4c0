#pragma once
#include <QLayout>

namespace underact::gui {

/// The layout of a widget that stands in another's layout, so that its margins are there already. spacing: logical
/// pixels; -1: the style's.
template <class Layout>
Layout* tight(QWidget* widget, int spacing = -1) {
  auto* const layout = new Layout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

}  // namespace underact::gui
