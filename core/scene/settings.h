#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/scene/description.h"

namespace underact::scene {

// What a person can change of a scene while it runs, a row of settings.cpp for each. Reading, checking and writing of
// scenes go by these rows, and so do edits by path.

/// A value. None: the key is left out, and nothing replaces it (a joint without that limit; no influence).
using SettingValue = std::variant<std::monostate, bool, double, Vec3, std::string>;

/// Whether it stands for a key that is left out.
inline bool isNone(const SettingValue& value) {
  return std::holds_alternative<std::monostate>(value);
}

/// Gain: one number for all axes, or one each. Choice: one of words.
enum class SettingKind : std::uint8_t { Number, Whole, Gain, Choice, Flag };

/// When its key is in a file. Always: whenever its object is; Required: the object needs it.
enum class KeyPresence : std::uint8_t { UnlessDefault, Always, Required };

/// A row of the table: one setting, and all that texts, checks and panels need to know of it.
struct Setting {
  const char* key;
  const char* label;  // for use in a sentence, as for undo: "blend width"
  const char* tip;    // a sentence or two
  const char* unit = "";
  double min = -kInfinity, max = kInfinity;
  bool is_above_min = false;  // least itself is not allowed
  KeyPresence given = KeyPresence::UnlessDefault;
  const char* wrong = nullptr;  // for a number outside the range: its last placeholders are least, most and the number
  const char* const* shown = nullptr;  // of a choice: what a panel shows for each word; null: the words

  SettingKind kind = SettingKind::Number;
  const char* object = nullptr;  // its path: "/constraints/*/influence"; "/control": a constraint's own, too
  std::vector<std::string> (*words)() = nullptr;  // of a choice, as in a file; the first is the default
};

/// All settings, in the order of the table.
const std::vector<Setting>& settings();

/// The path with stars: "/constraints/*/influence/t".
std::string pathOf(const Setting& setting);

/// The row of a path, with numbers or with stars; null: none. Of noise_mm, which two filters have, the first.
const Setting* findSetting(std::string_view path);

// A path is the JSON pointer of the value in the file: "/constraints/0/influence/t". A constraint without a control of
// its own uses the scene's; setting one gives it its own. Problems: no such setting; the scene has no such object.
Result<Setting> settingAt(const Description& scene, const std::string& path);
Result<SettingValue> valueAt(const Description& scene, const std::string& path);
/// The default where the file leaves the key out; none: there is none.
Result<SettingValue> defaultAt(const Description& scene, const std::string& path);

/// The scene with another value at path. None removes a limit, or, for the key that its object needs, the whole object:
/// t the influence. A value for a missing object adds the object. Problems: also a value that a file may not have;
/// whether it is compatible with the others, check() says.
Result<Description> withValue(const Description& scene, const std::string& path, const SettingValue& value);

/// Sets it from a text: as in a file, words without quotes, "none" for none. A star stands for each constraint, or
/// joint, that has the setting, and a key alone for its path with stars; a problem where none has it.
Result<Description> withText(const Description& scene, const std::string& path, const std::string& text);

/// The path with stars of a key: "/constraints/*/control/law", "/constraints/*/influence/t". Empty: no such key.
std::string everywhere(std::string_view key);

/// The path of the control of the constraint at index: the scene's where it is of a single constraint, else its own.
std::string controlPath(const Description& scene, std::size_t index);

/// The value as text in a file.
std::string fileTextOf(const SettingValue& value);

}  // namespace underact::scene
