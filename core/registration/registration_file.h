#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/registration/fit.h"

namespace underact::registration {

/// The registration of an arm, and the touches it was made from.
struct Registration {
  std::string arm;      // which one: see device::armKey()
  std::string date;     // 2026-11-22
  std::string program;  // "underact 0.1.0"
  std::vector<Touch> touches;
  Fit fit;  // of them
};

/// {"underact_registration": 1, "arm", "date", "program", "marks": [{"p_DM_mm", "p_WM_mm", "spread_mm"}, ...], "X_DW"};
/// keys: the guide, "Register the arm". The fit is computed from the reference points; X_DW may be left out, and is a
/// problem where it disagrees. Problems: all at once, with places.
Result<Registration> readRegistration(std::string_view text, const std::string& file_name);
/// Reads a file of that form. Problems, too: it cannot be read, or is too large.
Result<Registration> readRegistrationFile(const std::string& path);

/// The text of the file; readRegistration() reads the same back, number by number.
std::string registrationText(const Registration& registration);

}  // namespace underact::registration
