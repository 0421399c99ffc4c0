#pragma once
#include <iosfwd>

#include "core/record/session.h"

namespace underact::cli {

/// The metadata of a session: one JSON object on one line, or lines for a person.
void printAsJson(record::Session& session, std::ostream& out);
void printAsTable(record::Session& session, std::ostream& out);

}  // namespace underact::cli
