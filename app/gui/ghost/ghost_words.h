#pragma once
#include <QString>

#include "app/gui/ghost/ghost_load.h"
#include "core/ghost/follow.h"

namespace underact::gui {

/// "Followed for 23 s: 6.1 mm away on average, 18 mm at most, 84 % of the time within 10 mm."
QString resultText(const ghost::Tally& tally);

/// What to do; while the ghost moves the current distances, and at the end the result.
QString toldText(const ghost::State& state, const ghost::Options& options);

/// The result of the previous round; empty: there was none, or it is already shown.
QString lastText(const ghost::State& state);

/// The scene of the recording, if another one is in the window. here: the title of the latter.
QString elsewhereText(const LoadedGhost& ghost, const std::string& here);

/// That the ghost jumps, and why; empty: no jumps.
QString jumpsText(int jumps);

}  // namespace underact::gui
