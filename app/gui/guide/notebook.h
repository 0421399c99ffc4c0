#pragma once
#include <QString>

class QWidget;

namespace underact::gui {

/// Asks whether another program shall open a notebook. Of one of the guide it opens the user's own copy: in their
/// documents, made at the first time and never overwritten. Says so where it cannot be copied, or nothing opens it.
/// original: a path. Not modal.
void askToOpenNotebook(const QString& original, QWidget* parent);

}  // namespace underact::gui
