#include "core/helper/child.h"

#include <system_error>

#include "core/base/translate.h"

namespace underact::helper {
namespace {

constexpr int kPatience_ms = 2000;  // for one that has closed its output and still runs

}  // namespace

Child::Child(const Start& start) {
  system::Launch launch{.program = start.program, .arguments = {start.argument}};
  launch.given = {start.input_fd, start.output_fd, -1};
  if (start.file_fd >= 0) launch.given.push_back(start.file_fd);  // kFile
  process_ = system::Process(launch);
}

Ending Child::end(Ending ending) {
  if (!runs()) return Ending::NotStarted;
  if (ending != Ending::Exited || !process_.waitForEnd(kPatience_ms)) process_.kill();
  process_.waitForEnd(-1);
  if (ending != Ending::Exited) return ending;
  return process_.end().by_signal ? Ending::Crashed : code() == kNotSealed ? Ending::NotSandboxed : Ending::Exited;
}

std::string secondsText(double s) {
  const int tenths = static_cast<int>(s * 10.0);
  return s < 10.0 ? std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s"
                  : std::to_string(static_cast<int>(s)) + " s";
}

Sentence timeoutText(double max_time_s) {
  return phrase(
      TRANSLATE_NOOP("problem",
                     "Reading the file took longer than %1, although there was little to compute: the disk or "
                     "the network may be slow. Copy the file to this computer, and open the copy."),
      {secondsText(max_time_s)});
}

Sentence helperFailureText(Ending ending, const std::string& program, int error) {
  if (ending == Ending::NotStarted)
    return phrase(TRANSLATE_NOOP("problem", "%1 cannot be started: %2."),
                  {program, std::generic_category().message(error)});
  if (ending == Ending::NotSandboxed)
    return phrase(
        TRANSLATE_NOOP(
            "problem",
            "The file was not opened: %1 could not be isolated from the rest of this computer, which protects you from "
            "damaged or malicious files. Run the program on a system that lets it filter system calls (seccomp)."),
        {program});
  return {};
}

}  // namespace underact::helper
