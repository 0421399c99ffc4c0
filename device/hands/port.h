#pragma once
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "device/catalogue.h"
#include "device/hands/motion.h"

namespace underact::device::hands {

enum class Kind : std::uint8_t { Controller, Joystick, SpaceMouse };

/// A hand's device that is plugged in.
struct Seen {
  std::string id;  // the same whenever it is plugged in
  Sentence name;   // "Xbox Controller"
  Kind kind = Kind::Joystick;
  Readings readings;
  std::vector<Sentence> axis_names, button_names;  // "left stick, right"; shorter than there are: numbers do
  std::vector<Source> pairs;                       // of buttons and triggers that belong together
  Map usual;                                       // what it does until somebody says otherwise
  std::vector<Missing> missing;                    // empty: it can be read
};

/// All hands' devices of one kind that a computer has.
class Port {
 public:
  virtual ~Port() = default;
  /// What is there now and what it says; never waits. The window's thread.
  virtual std::vector<Seen> look() = 0;
  /// Why there is nothing of this kind here, and what works all the same; empty: nothing is wrong.
  virtual Sentence trouble() const { return {}; }
};

/// Gives those of the same id others: "ID", "ID-2", ...
void tellApart(std::vector<Seen>& seen);

}  // namespace underact::device::hands
