#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "device/hands/motion.h"

namespace underact::device::hands {

/// A map as a file says it, and of which device it is.
struct MapFile {
  std::string device, id;
  Map map;
};

/// {"underact_hand_map": 1, "device": .., "id": .., "ways": {"right": {"axis": 0, ...}, ...}, "buttons": {...}}; every
/// problem at once, with places. A way or button that is not there does nothing.
Result<MapFile> readMap(std::string_view text, const std::string& file_name);
Result<MapFile> readMapFile(const std::string& path);

/// The text that readMap() reads back to the same numbers, within a step of the last bit.
std::string mapText(const MapFile& file);

/// "axis 0", "buttons 4 5", "triggers 5 4", "nothing"; for commands and files of no structure.
std::string sourceText(const Source& source);
/// None: it is no such text, or names what no device has.
std::optional<Source> sourceOf(std::string_view text);

/// The name of a way in files and commands: "right", "turn_x".
const char* wayName(Way way);
const char* pressName(Press press);  // "stylus_1", "stylus_2", "stop"

}  // namespace underact::device::hands
