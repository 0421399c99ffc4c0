#pragma once
#include <string>

#include "tests/stories/story.h"

namespace underact::gui::test {

QString stepTitle(Story& story);
/// Moves the hand's goal there, and waits 2 s of ticks.
void leadHand(Story& story, const Vec3& p_mm);
bool isPanelOpen(Story& story, const char* panel);
/// What of the window a lesson changes: document, open panels, layers.
std::string shapeOf(Story& story);

}  // namespace underact::gui::test
