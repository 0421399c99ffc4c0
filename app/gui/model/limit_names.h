#pragma once
#include <QString>
#include <span>

#include "core/safety/limits.h"

namespace underact::gui {

/// A limit of the safety gate as shown to the user.
struct LimitName {
  const char* key;    // "speed": for object names
  const char* title;  // in the panel
  const char* word;   // "limited: speed"
  const char* tip;
  safety::CutBit bit;
  double safety::Cuts::*cut_N;  // null: it releases the whole force
};

/// In the order in which they act.
std::span<const LimitName> limitNames();

/// The word for the limit that reduces the force most now; empty: none acts.
QString mostLimiting(const safety::Cuts& cuts);

}  // namespace underact::gui
