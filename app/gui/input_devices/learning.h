#pragma once
#include <QString>
#include <optional>

#include "device/input/motion.h"

namespace underact::gui {

/// Learns one way or button of a map ("right", "stop") from what the user does with the device.
class Learning {
 public:
  /// before: the readings at the start. None: no such field.
  static std::optional<Learning> of(const QString& id, const QString& field, const device::input::Readings& before);
  const QString& id() const { return id_; }
  const QString& field() const { return field_; }
  /// The instruction for the user.
  QString asked() const;

  /// What was learnt.
  struct Step {
    std::optional<device::input::Map> map;  // none: not a value of that field
    bool fresh = true;                      // false: one undo step with the last change
    bool is_last = true;                    // false: the button for the opposite direction is still to come
  };
  /// map: the present one. None: nothing learnt yet.
  std::optional<Step> take(const device::input::Map& map, const device::input::Readings& now);

 private:
  Learning(const QString& id, const QString& field, const device::input::Readings& before)
      : id_(id), field_(field), before_(before) {}
  QString id_, field_;
  device::input::Readings before_;
  int first_ = -1;  // the button for one direction, while waiting for the other
};

}  // namespace underact::gui
