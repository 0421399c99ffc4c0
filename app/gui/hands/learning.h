#pragma once
#include <QString>
#include <optional>

#include "device/hands/motion.h"

namespace underact::gui {

/// One way or button of a device's map, learnt from what a person does with the device: "right", "stop".
class Learning {
 public:
  /// before: how the device is as it begins. None: there is no such field.
  static std::optional<Learning> of(const QString& id, const QString& field, const device::hands::Readings& before);
  const QString& id() const { return id_; }
  const QString& field() const { return field_; }
  /// What the person is asked for.
  QString asked() const;

  /// Something was learnt.
  struct Step {
    std::optional<device::hands::Map> map;  // none: it is no value for that field
    bool fresh = true;                      // false: it goes with the last one
    bool is_last = true;                    // false: a button for the other way is waited for
  };
  /// map: so far. None: nothing yet.
  std::optional<Step> take(const device::hands::Map& map, const device::hands::Readings& now);

 private:
  Learning(const QString& id, const QString& field, const device::hands::Readings& before)
      : id_(id), field_(field), before_(before) {}
  QString id_, field_;
  device::hands::Readings before_;
  int first_ = -1;  // the button for one way; the other one is waited for
};

}  // namespace underact::gui
