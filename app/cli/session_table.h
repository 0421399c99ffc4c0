#pragma once
#include <iosfwd>
#include <vector>

#include "core/record/session.h"
#include "core/record/session_difference.h"

namespace underact::cli {

/// The metadata of a session: one JSON object on one line, or lines for a person.
void printAsJson(record::Session& session, std::ostream& out);
void printAsTable(record::Session& session, std::ostream& out);

/// In what two sessions differ: a line each, or one JSON object.
void printDifferences(const std::vector<record::SessionDifference>& found, std::ostream& out);
void printDifferencesAsJson(const std::vector<record::SessionDifference>& found, std::ostream& out);

}  // namespace underact::cli
