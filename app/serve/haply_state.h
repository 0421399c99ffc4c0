#pragma once
#include <string>

#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/base/types.h"
#include "core/json/object_text.h"
#include "core/servo/snapshot.h"

namespace underact::serve::haply {

/// Names and numbers of the devices that clients see.
inline constexpr const char* kInverse3 = "0001";
inline constexpr const char* kGrip = "0002";

/// A place of W, m, in the frame of their base.
Vec3 placeOf(const Vec3& p_W);
/// A vector, such as a velocity.
Vec3 vectorOf(const Vec3& v_W);
/// A force of theirs, N, in W.
Vec3 forceOf(const Vec3& f_H);

/// What the client has set besides forces.
struct SessionWords {
  int number = 1;
  std::string profile = "default";
};

/// The state after a tick; the Inverse3 and the grip. is_full: with the configurations and the session, as in the first
/// message.
json::ObjectText stateText(const servo::TickRecord& tick, const arm::Geometry& geometry, const SessionWords& session,
                           bool is_full);
/// The session as GET /sessions/N has it.
json::ObjectText sessionText(const SessionWords& session);
/// As GET /version has it.
json::ObjectText versionText();

/// What a frame of a client asks for.
struct Frame {
  std::optional<Vec3> f_H;  // N; of the last set_cursor_force that is to be executed
  bool wants_all = false;
  std::optional<std::string> profile;
};
/// Reads a frame. Problems: it is not JSON, or a force is no three finite numbers. What is not there is passed over.
Result<Frame> readFrame(std::string_view text);

}  // namespace underact::serve::haply
