#pragma once
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "app/cli/json_object.h"
#include "core/registration/check.h"
#include "core/registration/registration_file.h"

namespace underact::cli {

// The output of `register`, for programs and for people.

JsonObject registrationObject(const registration::Registration& registration,
                              const std::vector<registration::Warning>& warnings);
void printRegistration(const registration::Registration& registration, std::ostream& out);

/// The error in the middle of the workspace for each number of reference points and errors of touching of 0.1 to 1 mm.
void printAccuracy(int draws, std::uint64_t seed, bool json, std::ostream& out);

}  // namespace underact::cli
