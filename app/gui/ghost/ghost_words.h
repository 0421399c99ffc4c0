#pragma once
#include <QString>

#include "app/gui/ghost/ghost_load.h"
#include "core/follow/follow.h"

namespace underact::gui {

/// "Followed for 23 s: 6.1 mm away on average, 18 mm at most, 84 % of the time within 10 mm."
QString resultText(const follow::Tally& tally);

/// What the one who follows should do; while the ghost goes how near he is, and at its end how near he was.
QString toldText(const follow::State& state, const follow::Options& options);

/// How near he was in the round before; empty: there was none, or that has just been said.
QString lastText(const follow::State& state);

/// In which scene it was recorded, where another one is in the window. here: that one's title.
QString elsewhereText(const LoadedGhost& ghost, const std::string& here);

/// That the ghost jumps, and why; empty: it does not.
QString jumpsText(int jumps);

}  // namespace underact::gui
