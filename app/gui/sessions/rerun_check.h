#pragma once
#include <QString>
#include <string>

#include "app/gui/kit/background.h"
#include "device/rerun_session.h"

namespace underact::gui {

/// Result of making a recorded run again.
struct RerunCheck {
  device::RerunResult result;
  bool cancelled = false;
  Problems problems;  // then there is no result
};

/// Makes the run of a session again and compares every tick with the recording, as underact-cli rerun does.
RerunCheck checkRerun(const std::string& session, WorkState& state);

/// The result in a sentence. alarm: the run could not be made again, or is not the same.
QString sentenceOf(const RerunCheck& check, bool& alarm);

}  // namespace underact::gui
