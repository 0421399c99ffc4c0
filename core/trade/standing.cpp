#include "core/trade/standing.h"

#include <algorithm>
#include <string_view>

#include "core/trade/front.h"
#include "core/trade/measures.h"

namespace underact::trade {
namespace {

/// The scene's own way is run as the scene has it: "auto" is more than the closed form that it is like.
std::vector<Entry> entriesOf(const Choice& choice, const Settings& base) {
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

// What a period of the simulated arm takes, with the hand and two looks at the clock, and a substep of it: from lab
// trade's front of 05_circle, 373 us for 1000 periods of one substep with a tick of 275 ns, and 23 ns a substep more.
constexpr double kArmPeriod_ns = 300.0, kArmSubstep_ns = 23.0;
constexpr double kFinestRate_hz = 16'000.0, kFinestSubstep_us = 5.0;  // of the runs that others are compared with

/// Of a second of one run.
double workOf_ns(double rate_hz, double substep_us, double tick_ns) {
  const double substeps = std::max(1.0, 1e6 / rate_hz / substep_us);
  return rate_hz * (tick_ns + kArmPeriod_ns + kArmSubstep_ns * substeps);
}

}  // namespace

const Summary* measuredOf(const Standing& standing, const Settings& settings) {
  const auto option = optionOf(*standing.choice, settings);
  if (!option && !standing.choice->same(settings, standing.base)) return nullptr;
  const std::string name = option ? standing.choice->options[*option].name : kAsItIs;
  const auto found = std::find_if(standing.options.begin(), standing.options.end(),
                                  [&](const Summary& one) { return one.option == name; });
  return found == standing.options.end() ? nullptr : &*found;
}

const Summary* recommendedOf(const Standing& standing) {
  const auto found = std::find_if(standing.options.begin(), standing.options.end(),
                                  [](const Summary& one) { return one.is_recommended; });
  return found == standing.options.end() ? nullptr : &*found;
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

std::vector<Standing> measureStandings(const scene::Description& scene, const std::vector<NamedHand>& hands,
                                       double seconds, int rate_hz, const Progress& goes_on) {
  const Settings base = settingsOf(scene, rate_hz);
  std::vector<const Choice*> asked;
  std::size_t cells = 0, done = 0;
  for (const Choice& choice : choices()) {
    if (!choice.applies(scene)) continue;
    asked.push_back(&choice);
    cells += entriesOf(choice, base).size() * hands.size();
  }
  const auto tell = [&] { return goes_on(static_cast<double>(done++) / static_cast<double>(cells)); };
  std::vector<Standing> standings;
  for (const Choice* choice : asked) {
    std::vector<Row> rows;
    Standing standing{choice, base, {}};
    const std::vector<Entry> entries = entriesOf(*choice, base);
    for (const NamedHand& hand : hands) {
      const auto add = [&](const Entry& entry, const Figures& figures) {
        rows.push_back({scene.title, hand.name, choice->key, entry.name, figures});
      };
      if (!measureEach(*choice, {scene, hand.hand, seconds}, base, entries, tell, add)) return standings;
    }
    for (const Entry& entry : entries) {
      const Summary summary = summaryOf(rows, choice->key, entry.name);
      if (summary.runs > 0) standing.options.push_back(summary);
    }
    recommend(choice->bound, standing.options);
    standings.push_back(std::move(standing));
  }
  return standings;
}

double secondsToMeasure(const scene::Description& scene, std::size_t hands, double seconds, int rate_hz,
                        double tick_ns) {
  const Settings base = settingsOf(scene, rate_hz);
  const double oracle_ns = workOf_ns(kFinestRate_hz, scene::kShortestSubstep_us, tick_ns);
  double work_ns = oracle_ns;
  for (const Settings& way : waysOf(scene, rate_hz))
    work_ns += workOf_ns(way.rate_hz, way.simulation.substep_us, tick_ns);
  for (const Choice& choice : choices()) {
    if (!choice.applies(scene)) continue;
    const auto entries = static_cast<double>(entriesOf(choice, base).size());
    // Each entry of these two runs its own finest run beside it; the others walk, two times each, and measure little.
    const bool is_rate = std::string_view(choice.key) == "rate";
    const bool is_simulation = std::string_view(choice.key) == "simulation";
    const double each_ns = is_rate         ? workOf_ns(kFinestRate_hz, base.simulation.substep_us, tick_ns)
                           : is_simulation ? workOf_ns(rate_hz, kFinestSubstep_us, tick_ns)
                                           : 2.0 * rate_hz * (tick_ns + kArmPeriod_ns);
    work_ns += entries * each_ns;
  }
  return 1e-9 * seconds * static_cast<double>(hands) * work_ns;
}

}  // namespace underact::trade
