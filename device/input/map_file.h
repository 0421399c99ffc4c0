#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "device/input/motion.h"

namespace underact::device::input {

/// A mapping as in a file, and the device that it is for.
struct MapFile {
  std::string device, id;
  Map map;
};

/// {"underact_hand_map": 1, "device": .., "id": .., "ways": {"right": {"axis": 0, ...}, ...}, "buttons": {...}}; every
/// problem at once, with places. A direction or button that is left out does nothing.
Result<MapFile> readMap(std::string_view text, const std::string& file_name);
Result<MapFile> readMapFile(const std::string& path);

/// Text that readMap() reads back to the same numbers, within a step of the last bit.
std::string mapText(const MapFile& file);

/// "axis 0", "buttons 4 5", "triggers 5 4", "nothing"; for commands and plain text files.
std::string sourceText(const Source& source);
/// None: not such a text, or it names something that no device has.
std::optional<Source> sourceOf(std::string_view text);

/// The name of a direction in files and commands: "right", "turn_x".
const char* motionAxisName(MotionAxis motion);
const char* pressName(ButtonRole press);  // "stylus_1", "stylus_2", "stop"

}  // namespace underact::device::input
