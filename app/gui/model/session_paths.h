#pragma once
#include <QDateTime>
#include <QString>

namespace underact::gui {

/// Where recordings go unless another folder is chosen: Underact/sessions in the user's documents folder.
QString defaultSessionFolder();

/// The file of a recording that starts at a time: "FOLDER/2026-11-21_19-56-47_sphere.h5"; a name not yet used in the
/// folder.
QString newSessionFile(const QString& folder, const QDateTime& when, const QString& scene_title);

/// Creates the folder if it is missing, for its owner only. Returns a sentence with the way out if it is not writable;
/// empty: it is.
QString prepareSessionFolder(const QString& folder);

}  // namespace underact::gui
