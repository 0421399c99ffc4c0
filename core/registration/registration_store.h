#pragma once
#include <optional>
#include <string>

#include "core/registration/registration_file.h"

namespace underact::registration {

/// The folder of registrations, a file for each arm, shared by window and command line: UNDERACT_REGISTRATION_DIR, else
/// underact/registrations in XDG_DATA_HOME (Windows: APPDATA), else in ~/.local/share.
std::string registrationFolder();

/// The file of that arm; characters that file names may not have are written as %XX.
std::string registrationPath(const std::string& arm, const std::string& folder);

/// Saves it for its arm in place of an earlier one. Problems: it cannot be written; then the earlier one stays.
Problems saveRegistration(const Registration& registration, const std::string& folder);

/// The registration of the arm; none: it is not registered. Problems: the file cannot be read, or is of another arm.
Result<std::optional<Registration>> loadRegistration(const std::string& arm, const std::string& folder);

/// Removes the registration of the arm. Problems: the file cannot be removed.
Problems removeRegistration(const std::string& arm, const std::string& folder);

}  // namespace underact::registration
