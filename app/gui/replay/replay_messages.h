#pragma once

namespace underact::gui {

struct FeatureParts;

/// Tells the window when a replay begins and ends, and the user what is wrong with a recording.
void connectReplayMessages(const FeatureParts& parts);

}  // namespace underact::gui
