#pragma once
#include <QString>

#include "core/system/places.h"

class QLabel;
class QWidget;

namespace underact::gui {

/// The folder of what comes with the program. Where that was not found: the first place where it was looked for, so
/// that a file named in it is told of as missing there, and is never one of the folder that one stands in.
QString shippedFolder(system::Resource resource);

/// Why it was not found, and where it was looked for, in the window's language; empty: it is there.
QString whyNotFound(system::Resource resource);

/// Says that, where it was not found; else it takes no room.
QLabel* notFoundLabel(system::Resource resource, const char* name, const QString& spoken, QWidget* parent);

}  // namespace underact::gui
