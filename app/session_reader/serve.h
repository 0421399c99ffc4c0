#pragma once

namespace underact::session_reader {

/// Answers what foreign_protocol.h asks of the session that is open at helper::kFile, until nobody asks any more;
/// sealed before the first byte of it is read. Gives the exit status.
int serve();

}  // namespace underact::session_reader
