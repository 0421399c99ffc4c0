#include "core/record/tick_table.h"

#include <algorithm>
#include <array>

#include "core/arm/forward.h"
#include "core/base/units.h"

namespace underact::record {
namespace {

constexpr std::array kTickColumns{
    Column{"tick", "", "number of the tick since the servo was made", Kind::Integer, 1, "", "", "tick"},
    Column{"time_ns", "ns", "of the sample, on the arm's clock", Kind::Integer, 1, "", "", "time_s"},
    Column{"q_rad", "rad", "joint angles 1 to 6 in the DH convention; m where a joint slides", Kind::Real, 6, "joints",
           "q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad", "q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad"},
    Column{"buttons", "", "of the stylus; bit 0: the one nearer to the tip", Kind::Unsigned, 1, "", "", "buttons"},
    Column{"p_WT_mm", "mm", "position of the tip in the workspace frame", Kind::Real, 3, "W",
           "p_WT_mm_x,p_WT_mm_y,p_WT_mm_z", "x_mm,y_mm,z_mm"},
    Column{"quat_WT", "", "turn of frame 6 in the workspace frame: w x y z", Kind::Real, 4, "W",
           "quat_WT_w,quat_WT_x,quat_WT_y,quat_WT_z"},
    Column{"v_WT_mm_per_s", "mm/s", "velocity of the tip, filtered by the gate", Kind::Real, 3, "W",
           "v_WT_mm_per_s_x,v_WT_mm_per_s_y,v_WT_mm_per_s_z"},
    Column{"p_WP_mm", "mm", "target of the first constraint that acts", Kind::Real, 3, "W",
           "p_WP_mm_x,p_WP_mm_y,p_WP_mm_z", "target_x_mm,target_y_mm,target_z_mm"},
    Column{"error_mm", "mm", "distance of tip and target over all constraints that act", Kind::Real, 1, "", "",
           "error_mm"},
    Column{"force_asked_N", "N", "force on the tip before the gate", Kind::Real, 3, "W",
           "force_asked_N_x,force_asked_N_y,force_asked_N_z", "force_asked_x_N,force_asked_y_N,force_asked_z_N"},
    Column{"force_sent_N", "N", "force on the tip after the gate", Kind::Real, 3, "W",
           "force_sent_N_x,force_sent_N_y,force_sent_N_z", "force_sent_x_N,force_sent_y_N,force_sent_z_N"},
    Column{"gate_level", "", "share of the force that the ramps let through", Kind::Real, 1, "", "", "gate_level"},
    Column{"cut_N", "N", "what the limits took away", Kind::Real, 1, "", "", "cut_N"},
    Column{"limits", "", "which limits acted, a bit each", Kind::Unsigned, 1, "", "", "limits"},
    Column{"heat", "", "of motors 1 to 3; 1: their continuous torque", Kind::Real, 3, "motors", "heat_1,heat_2,heat_3"},
    Column{"fault", "",
           "why the force is zero: 0 none, 1 no_sample, 2 stale_sample, 3 not_finite, 4 too_fast, "
           "5 too_late, 6 stood_still, 7 odd_clock, 8 asleep, 9 window_busy",
           Kind::Byte, 1, "", "", "fault"},
    Column{"alpha_beta_theta_rad", "rad", "angles of stylus, tip and target of the first influenced target", Kind::Real,
           3, "", "alpha_rad,beta_rad,theta_rad", "alpha_rad,beta_rad,theta_rad"},
    Column{"energy_mJ", "mJ", "put into the constraints by the stylus and not got back", Kind::Real, 1, "", "",
           "energy_mJ"},
    Column{"passive_N", "N", "what the passivity controllers add", Kind::Real, 1, "", "", "passive_N"},
    Column{"lateness_us", "us", "of the start of the tick", Kind::Real, 1, "", "", "lateness_us"},
    Column{"tick_us", "us", "that the tick took", Kind::Real, 1, "", "", "tick_us"},
    Column{"revision", "", "of the scene in effect, see changes", Kind::Integer, 1, "", "", "revision"},
    Column{"input", "", "1 sample came, 2 servo was to push, 4 started in this tick, 8 late", Kind::Byte},
};

constexpr double kMicrosecondPerNanosecond = 1e-3;

void packVec3(const Vec3& value, Packer& packer) {
  for (const double coordinate : value) packer.real(coordinate);
}

Vec3 unpackVec3(Unpacker& unpacker, double scale = 1.0) {
  Vec3 value;
  for (double& coordinate : value) coordinate = unpacker.real() / scale;
  return value;
}

}  // namespace

std::span<const Column> tickColumns() {
  return kTickColumns;
}

Eigen::Vector4d turnOf(const servo::TickRecord& record, const arm::Geometry& geometry) {
  if ((record.input & servo::kHadSample) == 0) return Eigen::Vector4d::Constant(kNotANumber);
  const Eigen::Quaterniond turn(arm::tipPose(geometry, record.q_rad).linear());
  return {turn.w(), turn.x(), turn.y(), turn.z()};
}

void pack(const servo::TickRecord& record, const arm::Geometry& geometry, Packer& packer) {
  packer.integer(record.tick);
  packer.integer(record.time_ns);
  for (const double angle_rad : arm::firstSix(record.q_rad)) packer.real(angle_rad);
  packer.unsigned32(record.buttons);
  packVec3(kMillimetrePerMetre * record.p_WT, packer);
  for (const double part : turnOf(record, geometry)) packer.real(part);
  packVec3(kMillimetrePerMetre * record.v_WT, packer);
  packVec3(kMillimetrePerMetre * record.p_WP, packer);
  packer.real(kMillimetrePerMetre * record.error_m);
  packVec3(record.f_asked_T_W, packer);
  packVec3(record.f_sent_T_W, packer);
  packer.real(record.level);
  packer.real(record.cut_N);
  packer.unsigned32(record.limits);
  packVec3(record.heat, packer);
  packer.byte(static_cast<std::uint8_t>(record.fault));
  packer.real(record.angles.alpha_rad);
  packer.real(record.angles.beta_rad);
  packer.real(record.angles.theta_rad);
  packer.real(1e3 * record.energy_J);
  packer.real(record.passive_N);
  packer.real(kMicrosecondPerNanosecond * static_cast<double>(record.lateness_ns));
  packer.real(kMicrosecondPerNanosecond * static_cast<double>(record.tick_ns));
  packer.integer(static_cast<std::int64_t>(record.revision));
  packer.byte(static_cast<std::uint8_t>(record.input));
}

std::vector<servo::TickRecord> unpackTicks(const Block& block) {
  const auto nanoseconds = [](double us) { return std::llround(us / kMicrosecondPerNanosecond); };
  std::vector<servo::TickRecord> records;
  records.reserve(static_cast<std::size_t>(block.rows));
  for (Unpacker unpacker(kTickColumns, block); !unpacker.isDone();) {
    servo::TickRecord& record = records.emplace_back();
    record.tick = unpacker.integer();
    record.time_ns = unpacker.integer();
    for (double& angle_rad : arm::firstSix(record.q_rad)) angle_rad = unpacker.real();
    record.buttons = unpacker.unsigned32();
    record.p_WT = unpackVec3(unpacker, kMillimetrePerMetre);
    for (int part = 0; part < 4; ++part) unpacker.real();
    record.v_WT = unpackVec3(unpacker, kMillimetrePerMetre);
    record.p_WP = unpackVec3(unpacker, kMillimetrePerMetre);
    record.error_m = unpacker.real() / kMillimetrePerMetre;
    record.f_asked_T_W = unpackVec3(unpacker);
    record.f_sent_T_W = unpackVec3(unpacker);
    record.level = unpacker.real();
    record.cut_N = unpacker.real();
    record.limits = unpacker.unsigned32();
    record.heat = unpackVec3(unpacker);
    const std::uint8_t fault = unpacker.byte();
    record.fault = fault < kFaultKinds ? static_cast<FaultKind>(fault) : FaultKind::None;
    record.angles.alpha_rad = unpacker.real();
    record.angles.beta_rad = unpacker.real();
    record.angles.theta_rad = unpacker.real();
    record.energy_J = unpacker.real() / 1e3;
    record.passive_N = unpacker.real();
    record.lateness_ns = nanoseconds(unpacker.real());
    record.tick_ns = nanoseconds(unpacker.real());
    record.revision = static_cast<std::uint64_t>(unpacker.integer());
    record.input = unpacker.byte();
    if (block.more_joints.empty()) continue;
    const std::span<double> beyond = arm::beyondSix(record.q_rad);
    record.joints = static_cast<int>(record.q_rad.size());
    std::copy_n(block.more_joints.begin() + static_cast<std::ptrdiff_t>((records.size() - 1) * beyond.size()),
                beyond.size(), beyond.begin());
  }
  return records;
}

}  // namespace underact::record
