#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/translate.h"
#include "core/scene/read_parts.h"

namespace underact::scene {
namespace {

constexpr auto kEachFilter = std::make_index_sequence<std::variant_size_v<Velocity>>{};

/// Calls attempt(a filter as it usually is) for each filter there is.
template <class Attempt, std::size_t... kIndex>
void eachFilter(Attempt&& attempt, std::index_sequence<kIndex...>) {
  (attempt(std::variant_alternative_t<kIndex, Velocity>{}), ...);
}

std::optional<Velocity> filterOf(const json::Value& value, const std::string& path, Findings& findings) {
  std::optional<Velocity> filter;
  std::vector<std::string> known;
  eachFilter(
      [&](const auto& usual) {
        known.emplace_back(filterName(usual));
        if (value.kind == json::Kind::String && value.text == known.back()) filter = usual;
      },
      kEachFilter);
  if (!filter) json::refuseWord(value, path, known, findings);
  return filter;
}

/// A setting that only another filter has: not unknown, but not used.
void refuseOthers(ObjectReader& object, const Velocity& chosen) {
  std::map<std::string, std::vector<std::string>> users;
  eachFilter(
      [&](auto usual) {
        eachSetting(usual, [&](const auto& setting, double) { users[setting.key].emplace_back(filterName(usual)); });
      },
      kEachFilter);
  std::visit([&](auto used) { eachSetting(used, [&](const auto& setting, double) { users.erase(setting.key); }); },
             chosen);
  for (const auto& [key, filters] : users) {
    object.refuse(
        key, said(TRANSLATE_NOOP("problem",
                                 "The filter \"%1\" does not use this; %2 would. Change the filter or take it away."),
                  {filterName(chosen), listed(filters, "and")}));
  }
}

}  // namespace

Velocity readVelocity(const json::Value& value, const std::string& path, Findings& findings) {
  Velocity velocity;
  if (!isKind(value, json::Kind::Object, path,
              said(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"filter\": \"kalman\"}"}), findings))
    return velocity;
  ObjectReader object(value, path, said(TRANSLATE_NOOP("problem", "a velocity")), findings);
  const json::Value* const filter = object.find("filter", true);
  const std::optional<Velocity> chosen =
      filter != nullptr ? filterOf(*filter, object.pathOf("filter"), findings) : std::nullopt;
  if (chosen) {
    velocity = *chosen;
    refuseOthers(object, velocity);
    std::visit(
        [&](auto& settings) {
          eachSetting(settings, [&](const auto& setting, double& number) {
            const json::Value* const found = object.find(setting.key);
            if (found != nullptr) readNumber(*found, object.pathOf(setting.key), number, findings);
          });
        },
        velocity);
  }
  object.finish(chosen.has_value());
  return velocity;
}

}  // namespace underact::scene
