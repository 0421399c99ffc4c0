#pragma once
#include <QString>
#include <vector>

class QWidget;

namespace underact::gui {

/// Which page of the guide is about a part of the window.
struct HelpPage {
  const char* part;   // the name of a widget, or what such a name begins with before a dot
  const char* place;  // "PAGE#heading"
};

/// The page for a widget: of the longest name that its own, or that of one it lies in, begins with.
QString helpPlaceOf(const QWidget* widget, const std::vector<HelpPage>& pages);

}  // namespace underact::gui
