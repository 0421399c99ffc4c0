#pragma once
#include <QString>
#include <vector>

class QWidget;

namespace underact::gui {

/// The page of the guide about a part of the window.
struct HelpPage {
  const char* part;   // the object name of a widget, or its prefix before a dot
  const char* place;  // "PAGE#heading"
};

/// The page for a widget: the row that matches the most of its object name, else of a parent's.
QString helpPageOf(const QWidget* widget, const std::vector<HelpPage>& pages);

}  // namespace underact::gui
