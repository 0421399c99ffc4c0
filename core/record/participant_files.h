#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::record {

/// All files that come from one participant.
struct ParticipantFiles {
  std::vector<std::string> sessions;  // with that code as subject
  std::vector<std::string> exports;   // of these: CSV with its metadata, Parquet, MCAP, plots
  Problems unread;                    // sessions that cannot be read, so that nobody knows whose they are
};

/// Looks for them in files and folders, with the folders below; links are not followed. An export is told by the word
/// of its session that it holds, or, where the session has none (version 0.1.0), not found. code: as in the field
/// subject, whole and case-sensitive; not empty.
ParticipantFiles filesOfParticipant(const std::string& code, const std::vector<std::string>& places);

/// Deletes them permanently, not into a bin. Problems: those that could not be deleted; the others are.
Problems removeFiles(const ParticipantFiles& files);

}  // namespace underact::record
