#pragma once
#include <QString>

#include "core/system/resource_paths.h"

class QLabel;
class QWidget;

namespace underact::gui {

/// The folder of files that come with the program. If it was not found: the first place searched, so that its files are
/// reported as missing there and never taken from the current folder.
QString shippedFolder(system::Resource resource);

/// Why it was not found and where it was searched for, in the window's language; empty: it was found.
QString notFoundReason(system::Resource resource);

/// A label that says so; hidden if the folder was found.
QLabel* notFoundLabel(system::Resource resource, const char* name, const QString& spoken, QWidget* parent);

}  // namespace underact::gui
