#pragma once
#include <QString>
#include <optional>

#include "device/hands/map_file.h"

namespace underact::gui {

/// The maps of hands' devices, a file each, in the user's settings.
class MapStore {
 public:
  MapStore();
  QString pathOf(const std::string& id) const;
  /// That was kept of a device; none: nothing was. Problems: of its file.
  Result<std::optional<device::hands::Map>> load(const std::string& id) const;
  /// Problems: why it could not be written.
  Problems save(const device::hands::MapFile& file) const;
  /// It is as usual again.
  void forget(const std::string& id) const;

 private:
  QString folder_;
};

}  // namespace underact::gui
