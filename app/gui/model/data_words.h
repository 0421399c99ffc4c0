#pragma once
#include <QString>
#include <string>

#include "core/lesson/lesson.h"
#include "core/scene/teaching.h"

namespace underact::gui {

/// A text of a scene file in the window's language, or unchanged without a translation. For display only, never to be
/// saved. Any thread.
QString sceneText(const std::string& text);

/// Translates all texts that are shown.
scene::Teaching translated(scene::Teaching teaching);
lesson::Lesson translated(lesson::Lesson lesson);

}  // namespace underact::gui
