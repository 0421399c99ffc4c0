#pragma once
#include <QDateTime>
#include <QString>

namespace underact::gui {

/// Where recordings go unless another folder is chosen: Underact/sessions among the user's documents.
QString usualSessionFolder();

/// The file of a recording that begins at a time: "FOLDER/2026-11-21_19-56-47_sphere.h5"; of a name that nothing in the
/// folder has yet.
QString newSessionFile(const QString& folder, const QDateTime& when, const QString& scene_title);

/// Makes the folder where it is missing, for its owner alone. Gives a sentence with the way out where nothing can be
/// written there; empty: all is well.
QString prepareSessionFolder(const QString& folder);

}  // namespace underact::gui
