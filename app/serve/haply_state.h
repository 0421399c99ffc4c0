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

/// The workspace transform of a device, which leads from its frame to that of the client's scene.
struct Workspace {
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 scale = Vec3::Ones();

  Vec3 vector(const Vec3& v_H) const { return rotation * scale.cwiseProduct(v_H); }
  Vec3 place(const Vec3& p_H) const { return position + vector(p_H); }
};
/// A force of the client's scene, N, in W. Its scale makes no force larger or smaller.
Vec3 forceOf(const Workspace& workspace, const Vec3& f_A);

/// What the client has set besides forces.
struct SessionWords {
  int number = 1;
  std::string profile = "default";
  Workspace arm = {}, grip = {};
};

/// The first three joints, deg.
Vec3 anglesOf(const servo::TickRecord& tick);
/// The state after a tick; the Inverse3 and the grip. turning: of those joints, deg/s. is_full: with the configurations
/// and the session, as in the first message.
json::ObjectText stateText(const servo::TickRecord& tick, const Vec3& turning, const arm::Geometry& geometry,
                           const SessionWords& session, bool is_full);
/// The session as GET /sessions/N has it.
json::ObjectText sessionText(const SessionWords& session);
/// As GET /version has it.
json::ObjectText versionText();

/// What a frame of a client asks for.
struct Frame {
  std::optional<Vec3> f_A;  // N; of the last set_cursor_force that is to be executed
  bool wants_all = false;
  bool names_profile = false;
  SessionWords session;  // with what the frame sets
};
/// Reads a frame. session: what holds before it. Problems: it is not JSON, or a force or a part of a transform is not
/// of finite numbers. What is not there is passed over.
Result<Frame> readFrame(std::string_view text, const SessionWords& session);

}  // namespace underact::serve::haply
