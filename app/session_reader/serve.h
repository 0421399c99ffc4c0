#pragma once

namespace underact::session_reader {

/// Answers the questions of foreign_protocol.h about the session that is open at helper::kFile, until there are no
/// more; sealed before the first byte is read. Returns the exit status.
int serve();

}  // namespace underact::session_reader
