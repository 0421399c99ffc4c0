#include <map>
#include <vector>

#include "core/base/translate.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

/// Refuses settings of other filters: not unknown, but not used.
void refuseOthers(ObjectReader& object, const Velocity& chosen) {
  std::map<std::string, std::vector<std::string>> users;
  for (const SettingOf<Velocity>& row : rowsOf<Velocity>()) {
    for (const auto& filter : kFilterWords) {
      Velocity other;
      rowsOf<Velocity>().front().set(other, std::string(filter.word));
      if (isThere(row, other)) users[row.is.key].emplace_back(filter.word);
    }
  }
  for (const SettingOf<Velocity>& row : rowsOf<Velocity>()) {
    if (isThere(row, chosen)) users.erase(row.is.key);
  }
  for (const auto& [key, filters] : users) {
    object.refuse(
        key, phrase(TRANSLATE_NOOP("problem",
                                   "This is for %2, not for the filter \"%1\". Change the filter, or remove this."),
                    {filterName(chosen), listed(filters, "and")}));
  }
}

}  // namespace

Velocity readVelocity(const json::Value& value, const std::string& path, Findings& findings) {
  Velocity velocity;
  if (!isKind(value, json::JsonKind::Object, path,
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"filter\": \"kalman\"}"}), findings))
    return velocity;
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a velocity filter")), findings);
  const std::span<const SettingOf<Velocity>> rows = rowsOf<Velocity>();
  const bool is_known = readSetting(object, rows.front(), velocity);  // the filter, which decides about the others
  if (is_known) {
    refuseOthers(object, velocity);
    for (const SettingOf<Velocity>& row : rows.subspan(1)) {
      if (isThere(row, velocity)) readSetting(object, row, velocity);
    }
  }
  object.finish(is_known);
  return velocity;
}

}  // namespace underact::scene
