#pragma once
#include <QString>
#include <span>

#include "core/safety/limits.h"

namespace underact::gui {

/// A limit of the gate as a person is told of it.
struct LimitName {
  const char* key;    // "speed": of objects
  const char* title;  // in the panel
  const char* word;   // "limited: speed"
  const char* tip;
  safety::CutBit bit;
  double safety::Cuts::*cut_N;  // null: it lets go as a whole
};

/// In the order in which they act.
std::span<const LimitName> limitNames();

/// The word of the limit that takes the most off the force now; empty: none acts.
QString mostLimiting(const safety::Cuts& cuts);

}  // namespace underact::gui
