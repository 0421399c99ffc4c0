#pragma once

namespace underact::gui {

struct FeatureParts;

/// The window is told of a replay that begins and ends, and a person of what is wrong with a recording.
void tellOfReplays(const FeatureParts& parts);

}  // namespace underact::gui
