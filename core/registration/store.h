#pragma once
#include <optional>
#include <string>

#include "core/registration/registration_file.h"

namespace underact::registration {

/// Where registrations are kept, a file an arm, for the window and the command line alike: UNDERACT_REGISTRATION_DIR,
/// else underact/registrations in XDG_DATA_HOME (Windows: APPDATA), else in ~/.local/share.
std::string storeFolder();

/// The file of that arm; what no file name may have stands as %XX.
std::string storePath(const std::string& arm, const std::string& folder);

/// Keeps it as that of its arm; the one before is gone. Problems: it cannot be written; then the one before stays.
Problems keep(const Registration& registration, const std::string& folder);

/// That of the arm; none: the arm is not registered. Problems: the file cannot be read, or is of another arm.
Result<std::optional<Registration>> recall(const std::string& arm, const std::string& folder);

/// The arm is not registered any more. Problems: the file cannot be removed.
Problems forget(const std::string& arm, const std::string& folder);

}  // namespace underact::registration
