#pragma once
#include <QString>
#include <span>

class QWidget;

namespace underact::gui {

/// What the guide says of a part of the window.
struct HelpPage {
  const char* part;   // the object name of a panel, section or dialog; those that go on from it with a dot are in it
  const char* place;  // "PAGE" or "PAGE#heading" of the guide
};

/// One row for every panel, section and dialog.
std::span<const HelpPage> helpPages();

/// The guide's place for a widget: of the smallest part that it is in. Null, or in none of them: the guide's first
/// page.
QString helpPlaceOf(const QWidget* widget);

}  // namespace underact::gui
