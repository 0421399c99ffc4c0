#pragma once
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

// The frame H in which Haply's service tells places of an Inverse3: its origin in the middle of the base, x to the
// right, y away from the person, z up. Source: Haply's documentation; W lies in it so that the middle of both
// workspaces is the same point, in front of the base.

/// p_H, m, of a place in W, m. Not finite in, not finite out.
Vec3 haplyPlaceFromWorkspace(const Vec3& p_W) noexcept UNDERACT_REAL_TIME;
/// Its inverse: p_W, m.
Vec3 workspacePlaceFromHaply(const Vec3& p_H) noexcept UNDERACT_REAL_TIME;
/// R_HW, which turns vectors and orientations of W into H.
Mat3 haplyFromWorkspace() noexcept UNDERACT_REAL_TIME;
/// p_HW, m: where the origin of W is in H.
Vec3 workspaceMiddleInHaply() noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
