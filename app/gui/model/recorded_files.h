#pragma once
#include <QString>
#include <string>
#include <vector>

namespace underact::gui {

/// Where the meshes and curves of a recording are looked for besides the folder of the session: where the person said,
/// the latest first, beside the scenes opened lately, and where scenes ship. Any thread.
std::vector<std::string> recordedFilesFolders();

/// Remembers that they are in folder, too.
void rememberRecordedFiles(const QString& folder);

}  // namespace underact::gui
