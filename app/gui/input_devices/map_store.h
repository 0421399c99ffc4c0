#pragma once
#include <QString>
#include <optional>

#include "device/input/map_file.h"

namespace underact::gui {

/// The maps of the input devices, one file each, in the user's settings.
class MapStore {
 public:
  MapStore();
  QString pathOf(const std::string& id) const;
  /// The saved map of a device; none: there is none. Problems: those of its file.
  Result<std::optional<device::input::Map>> load(const std::string& id) const;
  /// Problems: why the map could not be saved.
  Problems save(const device::input::MapFile& file) const;
  /// Deletes the saved map: the device uses its defaults again.
  void forget(const std::string& id) const;

 private:
  QString folder_;
};

}  // namespace underact::gui
