#include "app/cli/setting_overrides.h"

#include "core/scene/settings.h"

namespace underact::cli {

std::pair<std::string, std::string> sidesOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  return {text.substr(0, equals), equals == std::string::npos ? "" : text.substr(equals + 1)};
}

Option addSet(Command command, std::vector<std::string>& overrides, const std::string& what) {
  return command.option("--set", overrides, what).oneEachTime().word("PATH=VALUE").check([](const std::string& text) {
    const bool has_both = text.find('=') != std::string::npos && text.front() != '=';
    return std::string(has_both ? "" : "must be PATH=VALUE, as in kp_N_per_mm=0.8");
  });
}

Result<scene::Description> withOverrides(scene::Description scene, const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides) {
    const auto [path, value] = sidesOf(text);
    Result<scene::Description> set = scene::withText(scene, path, value);
    if (!set) {
      Problems problems = set.problems();
      for (Problem& problem : problems) problem.place = {"the settings", 1, 0, text};
      return problems;
    }
    scene = std::move(set).value();
  }
  return scene;
}

}  // namespace underact::cli
