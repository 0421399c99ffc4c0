#pragma once
#include <QString>
#include <string>
#include <vector>

namespace underact::gui {

/// Where meshes and curves of a recording are searched for besides the session's folder: the folders that the user has
/// named, the latest first, those of recently opened scenes, and that of the shipped scenes. Any thread.
std::vector<std::string> recordedFilesFolders();

/// Remembers folder as another place to search.
void rememberRecordedFiles(const QString& folder);

}  // namespace underact::gui
