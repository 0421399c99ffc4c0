#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace underact::chain {

/// The axis, and whether the step rotates about it or shifts along it.
enum class StepKind : std::uint8_t { TurnX, TurnY, TurnZ, ShiftX, ShiftY, ShiftZ };
inline constexpr std::size_t kStepKinds = 6;
/// Whether the amount of such a step is an angle.
inline bool isRotationStep(StepKind kind) {
  return kind <= StepKind::TurnZ;
}

/// One rotation about an axis (rad) or one shift along it (m).
struct Step {
  StepKind kind = StepKind::TurnX;
  double amount = 0.0;
  friend bool operator==(const Step&, const Step&) = default;
};

/// The axes of a step: those of the present frame, or fixed ones.
enum class Axes : std::uint8_t { Moving, Fixed };

/// The pose after the step alone. Not finite in, not finite out.
Pose poseOf(const Step& step) noexcept;

/// The frame after each step, in the initial frame: X_k = X_(k-1) S_k about moving axes, X_k = S_k X_(k-1) about fixed
/// ones. As many as there are steps.
/// Source: Craig, Introduction to Robotics, 3rd ed., section 2.8 (X-Y-Z fixed and Z-Y-X Euler angles).
std::vector<Pose> composed(std::span<const Step> steps, Axes axes);

}  // namespace underact::chain
