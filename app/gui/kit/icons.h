#pragma once
#include <QIcon>
#include <QString>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// An icon painted with a pen, crisp at any size, in the theme's ink. name: "start", "stop", "record", "play", "pause",
/// "back", "forward", "fit", "front", "top", "side", "isometric", "layers", "help", "open", "save", "undo", "redo",
/// "reset", "question", "warning", "information", "critical", a panel's key ("feel"), a shape's type ("sphere"),
/// "file", "underact". An unknown name gives an empty icon.
QIcon icon(const QString& name, const Theme& theme);

/// An icon of a picture file, read when first painted. It reports whatever size is requested.
QIcon fileIcon(const QString& path);

/// The colour of Stop and of a fault: it has no other meaning in the view, so it stands out.
QColor alarm(const Theme& theme);

/// The colour of a value beyond a limit, but allowed.
QColor amber(const Theme& theme);

}  // namespace underact::gui
