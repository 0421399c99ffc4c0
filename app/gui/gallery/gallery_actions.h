#pragma once

class QWidget;

namespace underact::gui {

class Actions;

/// help.figures: the figures of the thesis. With an argument ("4.5,B.1") only those are made.
/// figures.open: those of a list that `underact-cli figures` wrote.
void addGalleryActions(Actions& actions, QWidget* window);

}  // namespace underact::gui
