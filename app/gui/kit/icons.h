#pragma once
#include <QIcon>
#include <QString>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// An icon painted with a pen, crisp at any size, in the theme's ink. name: "start", "stop", "record", "play", "pause",
/// "back", "forward", "fit", "front", "top", "side", "isometric", "layers", "help", "open", "save", "undo", "redo",
/// "reset", a shape's type ("sphere"), "file", "underact". An unknown name gives an empty icon.
QIcon icon(const QString& name, const Theme& theme);

/// Of a picture file, which is read when the icon is painted for the first time. It says it has the size asked for.
QIcon fileIcon(const QString& path);

/// The colour of Stop and of a fault: not one of the meanings in the view, so it stands out there.
QColor alarm(const Theme& theme);

/// Beyond a limit, but allowed.
QColor amber(const Theme& theme);

}  // namespace underact::gui
