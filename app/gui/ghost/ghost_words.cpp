#include "app/gui/ghost/ghost_words.h"

#include "app/gui/kit/words.h"
#include "app/gui/model/data_words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

QString lengthText(double length_m, int decimals) {
  return numberText(kMillimetrePerMetre * length_m, decimals);
}

QString wholePercent(double share) {
  return numberText(100.0 * share, 0);
}

}  // namespace

QString resultText(const ghost::Tally& tally) {
  QString text =
      tr("Followed for %1 s: %2 mm away on average, %3 mm at most, %4 % of the time within %5 mm.")
          .arg(numberText(tally.followed_s, 0), lengthText(tally.mean_m(), 1), lengthText(tally.largest_m, 0),
               wholePercent(tally.nearShare()), lengthText(ghost::kNear_m, 0));
  if (tally.waited_s >= 0.5) text += " " + tr("The ghost waited for %1 s.").arg(numberText(tally.waited_s, 0));
  return text;
}

QString toldText(const ghost::State& state, const ghost::Options& options) {
  if (state.phase == ghost::Phase::Ended) return resultText(state.tally);
  if (!options.plays) return tr("The ghost is paused. Press Play to continue.");
  if (state.phase == ghost::Phase::Waiting)
    return tr("The ghost waits until you are within %1 mm.").arg(lengthText(0.5 * options.waits_beyond_m, 0));
  if (state.phase == ghost::Phase::Ready)
    return tr("Move to the ghost: it starts when you are within %1 mm.").arg(lengthText(ghost::kNear_m, 0));
  const ghost::Tally& tally = state.tally;
  return tr("Average %1 mm, largest %2 mm, %3 % within %4 mm")
      .arg(lengthText(tally.mean_m(), 1), lengthText(tally.largest_m, 1), wholePercent(tally.nearShare()),
           lengthText(ghost::kNear_m, 0));
}

QString lastText(const ghost::State& state) {
  if (!state.last_round || state.phase == ghost::Phase::Ended) return {};
  return tr("Last round: %1").arg(resultText(*state.last_round));
}

QString elsewhereText(const LoadedGhost& ghost, const std::string& here) {
  return ghost.scene->title == here ? tr("The scene has changed since the recording.")
                                    : tr("It was recorded in the scene “%1”.").arg(sceneText(ghost.scene->title));
}

QString jumpsText(int jumps) {
  if (jumps == 0) return {};
  return jumps == 1 ? tr("The recording has a gap: the ghost jumps there.")
                    : tr("The recording has %1 gaps: the ghost jumps there.").arg(jumps);
}

}  // namespace underact::gui
