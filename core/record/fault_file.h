#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/servo/host.h"

namespace underact::record {

inline constexpr std::size_t kFaultFilesKept = 20;

/// The texts for a fault.
struct FaultWords {
  std::string kind;  // "no_sample"
  Sentence what;
  Sentence what_to_do;
};
/// The sentences of whatHappened() and whatToDo(), and the word of name().
FaultWords wordsOf(const Fault& fault);
/// The words of a fault, followed by what the device reports, see DevicePort::trouble().
FaultWords wordsOf(const servo::FaultReport& report);

/// A time as ISO 8601 in UTC: "2026-11-21T19:56:47Z". unix_time_s: from year 1 to 9999.
std::string isoTime(std::int64_t unix_time_s);

/// A fault report as a JSON object: texts, time, servo, scene, and the last second of ticks with the columns of a CSV
/// recording. Numbers read back to the same double; one that is not finite is null.
std::string faultText(const servo::FaultReport& report, const FaultWords& words);

/// Writes text beside path, then renames over path; only its owner may read it. Problems: why it cannot be written;
/// then nothing is left behind.
Problems writeFaultFile(std::string_view text, const std::string& path);

/// Saves a fault as a new file of folder, which is made if necessary, and removes the oldest faults beyond
/// kFaultFilesKept; other files of the folder are not touched. Gives the path. Problems: it cannot be written.
Result<std::string> saveFault(const servo::FaultReport& report, const FaultWords& words, const std::string& folder);

}  // namespace underact::record
