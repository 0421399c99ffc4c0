#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/arm/preset.h"
#include "core/base/sentence.h"
#include "core/scene/description.h"
#include "core/servo/snapshot.h"
#include "core/target/manipulated.h"

namespace underact::lesson {

inline constexpr std::size_t kMaxParts = 8;
/// The values of a quantity; unused ones are not a number, and so are all where it is not defined now.
using Values = std::array<double, kMaxParts>;

/// What quantities are computed from in a tick.
struct Observation {
  const servo::TickRecord& tick;
  const scene::Description& scene;  // in effect
  const arm::Preset& arm;           // that it names
  const target::Robot& robot;       // the scene's first virtual manipulator, of this tick or shortly before
};

/// The distance of two values. Largest: the largest difference, of angles in degrees. Angle: that between two
/// directions, degrees.
enum class DistanceMetric : std::uint8_t { Euclidean, Largest, Angle };

/// What the scene needs for the quantity to be defined.
enum class Needs : std::uint8_t { Nothing, Influence, Robot, Energy };

/// Something that is measured, in the units of scene files and of the screen.
struct Quantity {
  const char* key;   // of lesson files: "force_N"
  const char* name;  // in sentences, their first word: "The force"
  const char* unit;  // "N"; empty: it has none
  int decimals;      // that are significant
  std::size_t parts;
  DistanceMetric apart;
  Needs needs;
  const char* what;  // one sentence
  Values (*of)(const Observation& seen);
};

/// All there are, in the order of the guide.
std::span<const Quantity> quantities();

/// Null: there is none of that key.
const Quantity* findQuantity(std::string_view key);

/// The unit of how far two of its values are apart.
const char* unitOfDistance(const Quantity& quantity);

/// Why the scene cannot have it, in a sentence; empty: it can.
Sentence missingReason(const Quantity& quantity, const scene::Description& scene);

}  // namespace underact::lesson
