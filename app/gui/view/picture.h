#pragma once
#include <QImage>
#include <string>

#include "app/gui/kit/theme.h"
#include "core/base/result.h"

namespace underact::gui {

/// The size of the pictures in the list of scenes.
inline constexpr QSize kSmallPicture(160, 120);

/// A scene as the list shows it: the shape and the stylus, without words. Problems: of the file.
Result<QImage> smallPicture(const std::string& scene_file, const Theme& theme);

/// Draws the 3D view of a scene file into a PNG. Problems go to stderr. Gives the exit status: 0, 1 (a bad scene), 4 (a
/// file that cannot be read or written).
int drawPicture(const std::string& scene_file, const std::string& out);

/// Draws the small pictures of all scenes that come with the program, light and dark, into a folder. As drawPicture().
int drawSmallPictures(const std::string& folder);

}  // namespace underact::gui
