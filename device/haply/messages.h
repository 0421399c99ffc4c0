#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"

namespace underact::device::haply {

/// How the service wants a force: "values" up to v3.1, "vector" from v3.5 on.
enum class Form : std::uint8_t { Values, Vector };

/// What is known of an Inverse3, and of the grip in its hand: of all messages so far, since later ones may leave out
/// what has not changed. m, deg, in the frame H of the service (core/arm/haply_frame.h).
struct Told {
  std::string id;    // which one is meant; empty: the first, whose it becomes
  std::string type;  // "inverse3x"; of its configuration, as all up to axes
  std::string firmware;
  std::string axes = "XYZ";        // the permutation of its basis
  bool is_middle_origin = false;   // places count from the middle of its workspace, not from its base
  std::vector<std::string> ids;    // of all that are there
  Vec3 p_HT = Vec3::Zero();        // the cursor, m
  std::optional<Mat3> R_HT;        // of the grip; none: there is no grip
  std::uint32_t buttons = 0;       // of the grip; bit 0: a
  std::optional<Vec3> angles_deg;  // of its own three joints, which are not those of a serial arm
  bool is_calibrated = true, has_power = true, is_ready = true;
};

/// What a message said of the arm.
enum class Heard : std::uint8_t {
  Place,    // where it is
  Nothing,  // something else: an event, an error
  Missing,  // the arm is not there
  Wrong,    // not JSON, or no place that can be
};
/// Takes up a message. Whatever comes, told stays as it was where the message is wrong.
Heard hearMessage(std::string_view text, Told& told);

/// From the answer to GET /version. Empty, or not understood: Values.
Form formOf(std::string_view version_answer);

/// The first frame: everything is asked for; from v3.5 on the session is given a name.
std::string greetingText(Form form);
/// A frame with a force, N, in H, which the service answers with the state.
std::string forceText(std::string_view id, Form form, const Vec3& f_H);

}  // namespace underact::device::haply
