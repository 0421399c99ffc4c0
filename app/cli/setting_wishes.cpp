#include "app/cli/setting_wishes.h"

#include "core/scene/settings.h"

namespace underact::cli {

std::pair<std::string, std::string> sidesOf(const std::string& wish) {
  const std::size_t equals = wish.find('=');
  return {wish.substr(0, equals), equals == std::string::npos ? "" : wish.substr(equals + 1)};
}

Option addSet(Command command, std::vector<std::string>& wishes, const std::string& what) {
  return command.option("--set", wishes, what).oneEachTime().word("PATH=VALUE").check([](const std::string& wish) {
    const bool has_both = wish.find('=') != std::string::npos && wish.front() != '=';
    return std::string(has_both ? "" : "must be PATH=VALUE, as in kp_N_per_mm=0.8");
  });
}

Result<scene::Description> withWishes(scene::Description scene, const std::vector<std::string>& wishes) {
  for (const std::string& wish : wishes) {
    const auto [path, value] = sidesOf(wish);
    Result<scene::Description> set = scene::withText(scene, path, value);
    if (!set) {
      Problems problems = set.problems();
      for (Problem& problem : problems) problem.place = {"the settings", 1, 0, wish};
      return problems;
    }
    scene = std::move(set).value();
  }
  return scene;
}

}  // namespace underact::cli
