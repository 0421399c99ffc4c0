#pragma once
#include <QString>

class QMimeData;

namespace underact::gui {

/// The filter of a dialog for all files that the window opens.
QString filterOfAll();

/// What becomes of something that is dragged over the window.
struct Dragged {
  QString path;      // of the file; empty: nothing that can be dropped
  QString sentence;  // what dropping it does, or what it is instead
  bool opens = false;
};
/// Reads the beginning of the file.
Dragged draggedOf(const QMimeData& data);

}  // namespace underact::gui
