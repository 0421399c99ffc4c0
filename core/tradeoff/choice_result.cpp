#include "core/tradeoff/choice_result.h"

#include <algorithm>

#include "core/tradeoff/measures.h"

namespace underact::tradeoff {
namespace {

/// The options, with the scene's own settings as they are: "auto" is more than the closed form that it resembles.
std::vector<Entry> entriesWithOwn(const Choice& choice, const Settings& base) {
  std::vector<Entry> entries;
  bool has_own = false;
  for (const Option& option : choice.options) {
    Settings settings = base;
    option.choose(settings);
    const bool is_own = choice.same(settings, base);
    has_own = has_own || is_own;
    entries.push_back({option.name, is_own ? base : settings});
  }
  if (!has_own) entries.push_back({kAsItIs, base});
  return entries;
}

}  // namespace

const Summary* measuredOf(const ChoiceResult& choice_result, const Settings& settings) {
  const auto option = optionOf(*choice_result.choice, settings);
  if (!option && !choice_result.choice->same(settings, choice_result.base)) return nullptr;
  const std::string name = option ? choice_result.choice->options[*option].name : kAsItIs;
  const auto found = std::find_if(choice_result.options.begin(), choice_result.options.end(),
                                  [&](const Summary& one) { return one.option == name; });
  return found == choice_result.options.end() ? nullptr : &*found;
}

const Summary* recommendedOf(const ChoiceResult& choice_result) {
  const auto found = std::find_if(choice_result.options.begin(), choice_result.options.end(),
                                  [](const Summary& one) { return one.is_recommended; });
  return found == choice_result.options.end() ? nullptr : &*found;
}

std::string valueText(const Choice& choice, const scene::Description& scene, const Settings& settings) {
  for (const Option& option : choice.options) {
    Settings other = settings;
    option.choose(other);
    if (other == settings) return option.name;
  }
  for (const Option& option : choice.options) {
    Settings other = settings;
    option.choose(other);
    const std::vector<Difference> all = differences(scene, other, settings);
    if (!all.empty()) return all.front().after;
  }
  return kAsItIs;
}

std::vector<ChoiceResult> measureChoices(const scene::Description& scene, const std::vector<NamedHand>& hands,
                                         double seconds, int rate_hz, const Progress& goes_on) {
  const Settings base = settingsOf(scene, rate_hz);
  std::vector<const Choice*> asked;
  std::size_t cells = 0, done = 0;
  for (const Choice& choice : choices()) {
    if (!choice.applies(scene)) continue;
    asked.push_back(&choice);
    cells += entriesWithOwn(choice, base).size() * hands.size();
  }
  const auto tell = [&] { return goes_on(static_cast<double>(done++) / static_cast<double>(cells)); };
  std::vector<ChoiceResult> choice_results;
  for (const Choice* choice : asked) {
    std::vector<TradeoffRow> rows;
    ChoiceResult choice_result{choice, base, {}};
    const std::vector<Entry> entries = entriesWithOwn(*choice, base);
    for (const NamedHand& hand : hands) {
      const auto add = [&](const Entry& entry, const Figures& figures) {
        rows.push_back({scene.title, hand.name, choice->key, entry.name, figures});
      };
      if (!measureEach(*choice, benchOf(scene, hand.hand, seconds), base, entries, tell, add)) return choice_results;
    }
    for (const Entry& entry : entries) {
      const Summary summary = summaryOf(rows, choice->key, entry.name);
      if (summary.runs > 0) choice_result.options.push_back(summary);
    }
    recommend(choice->bound, choice_result.options);
    choice_results.push_back(std::move(choice_result));
  }
  return choice_results;
}

}  // namespace underact::tradeoff
