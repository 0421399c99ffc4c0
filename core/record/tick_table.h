#pragma once
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "core/record/field.h"
#include "core/servo/snapshot.h"

namespace underact::record {

/// The words for a fault's number, of /ticks and /faults.
inline constexpr std::string_view kFaultMeaning =
    "why the force is zero: 0 none, 1 no_sample, 2 stale_sample, 3 not_finite, 4 too_fast, 5 too_late, "
    "6 stood_still, 7 odd_clock, 8 asleep, 9 window_busy";
/// All kinds.
template <>
inline constexpr std::pair kEnumerators<FaultKind>{FaultKind::None, static_cast<FaultKind>(kFaultKinds - 1)};

using Tick = servo::TickRecord;  // a row of /ticks

/// The turn of the stylus in W as a quaternion, w x y z, which the servo computes only where a scene needs it. Not
/// numbers where the arm gave no sample. geometry: of the arm.
Eigen::Vector4d turnOf(const servo::TickRecord& record, const arm::Geometry& geometry);

/// The joints of /ticks; those beyond it are in /joints, and in all other forms of a tick at the end.
inline constexpr std::size_t kJointsOfTicks = 6;
inline constexpr int kLastInCsv = 1000;
inline constexpr Field kMoreJoints{
    Column{"q_more_rad", "rad", "joint angles 7 and 8, of an arm that has them; m where a joint slides",
           NumberKind::Real, "q7_rad,q8_rad", 2, "joints", "q7_rad,q8_rad", kLastInCsv},
    [](auto& record) { return std::span(record.q_rad).template subspan<kJointsOfTicks>(); }};

/// The columns of /ticks, in the order of the file. Lengths mm, angles rad, forces N. A new one is a row here, with
/// csv_since above all others, and a member of the record; resources/guide/session_columns.md and columns.json are made
/// from it.
template <>
inline constexpr std::tuple kFields<Tick>{
    Field{Column{"tick", "", "number of the tick since the servo was made", NumberKind::Integer, "tick"}, &Tick::tick},
    Field{Column{"time_ns", "ns", "of the sample, on the arm's clock", NumberKind::Integer, "time_s"}, &Tick::time_ns},
    Field{Column{"q_rad", "rad", "joint angles 1 to 6 in the DH convention; m where a joint slides", NumberKind::Real,
                 "q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad", 6, "joints", "q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad"},
          [](auto& record) { return std::span(record.q_rad).template first<kJointsOfTicks>(); }},
    Field{Column{"buttons", "", "of the stylus; bit 0: the one nearer to the tip", NumberKind::Unsigned, "buttons", 1,
                 "", "", 1},
          &Tick::buttons},
    Field{Column{"p_WT_mm", "mm", "position of the tip in the workspace frame", NumberKind::Real, "x_mm,y_mm,z_mm", 3,
                 "W"},
          &Tick::p_WT, kMillimetrePerMetre},
    Field{Column{"quat_WT", "", "turn of frame 6 in the workspace frame: w x y z", NumberKind::Real, "", 4, "W",
                 "quat_WT_w,quat_WT_x,quat_WT_y,quat_WT_z"},
          &turnOf},
    Field{Column{"v_WT_mm_per_s", "mm/s", "velocity of the tip, filtered by the gate", NumberKind::Real, "", 3, "W"},
          &Tick::v_WT, kMillimetrePerMetre},
    Field{Column{"p_WP_mm", "mm", "target of the first constraint that acts", NumberKind::Real,
                 "target_x_mm,target_y_mm,target_z_mm", 3, "W"},
          &Tick::p_WP, kMillimetrePerMetre},
    Field{Column{"error_mm", "mm", "distance of tip and target over all constraints that act", NumberKind::Real,
                 "error_mm"},
          &Tick::error_m, kMillimetrePerMetre},
    Field{Column{"force_asked_N", "N", "force on the tip before the gate", NumberKind::Real,
                 "force_asked_x_N,force_asked_y_N,force_asked_z_N", 3, "W"},
          &Tick::f_asked_T_W},
    Field{Column{"force_sent_N", "N", "force on the tip after the gate", NumberKind::Real,
                 "force_sent_x_N,force_sent_y_N,force_sent_z_N", 3, "W"},
          &Tick::f_sent_T_W},
    Field{Column{"gate_level", "", "share of the force that the ramps let through", NumberKind::Real, "gate_level"},
          &Tick::level},
    Field{Column{"cut_N", "N", "what the limits took away", NumberKind::Real, "cut_N"}, &Tick::cut_N},
    Field{Column{"limits", "", "which limits acted, a bit each", NumberKind::Unsigned, "limits", 1, "", "", 2},
          &Tick::limits},
    Field{Column{"heat", "", "of motors 1 to 3; 1: their continuous torque", NumberKind::Real, "", 3, "motors",
                 "heat_1,heat_2,heat_3"},
          &Tick::heat},
    Field{Column{"fault", "", kFaultMeaning, NumberKind::Byte, "fault"}, &Tick::fault},
    Field{Column{"alpha_beta_theta_rad", "rad", "angles of stylus, tip and target of the first influenced target",
                 NumberKind::Real, "alpha_rad,beta_rad,theta_rad", 3, "", "alpha_rad,beta_rad,theta_rad"},
          [](auto& record) {
            return std::tie(record.angles.alpha_rad, record.angles.beta_rad, record.angles.theta_rad);
          }},
    Field{Column{"energy_mJ", "mJ", "put into the constraints by the stylus and not got back", NumberKind::Real,
                 "energy_mJ", 1, "", "", 3},
          &Tick::energy_J, 1e3},
    Field{Column{"passive_N", "N", "what the passivity controllers add", NumberKind::Real, "passive_N", 1, "", "", 3},
          &Tick::passive_N},
    Field{Column{"lateness_us", "us", "of the start of the tick", NumberKind::Real, "lateness_us"}, &Tick::lateness_ns,
          1e-3},
    Field{Column{"tick_us", "us", "that the tick took", NumberKind::Real, "tick_us"}, &Tick::tick_ns, 1e-3},
    Field{Column{"revision", "", "of the scene in effect, see changes", NumberKind::Integer, "revision", 1, "", "", 1},
          &Tick::revision},
    Field{Column{"input", "", "1 sample came, 2 servo was to push, 4 started in this tick, 8 late", NumberKind::Byte},
          &Tick::input}};

/// All fields of a tick: those of /ticks, and the joints beyond the sixth.
inline constexpr std::tuple kTickFields = std::tuple_cat(kFields<Tick>, std::tuple{kMoreJoints});

/// The columns of /ticks. more_joints: with the joints beyond the sixth at the end.
std::span<const Column> tickColumns(bool more_joints = false);

/// Packs one row, for a Packer of tickColumns(more_joints). geometry: see turnOf().
void pack(const servo::TickRecord& record, const arm::Geometry& geometry, Packer& packer, bool more_joints = false);

/// The numbers of a tick in the order and the units of tickColumns(true), as doubles. geometry: see turnOf().
std::vector<double> numbersOf(const servo::TickRecord& record, const arm::Geometry& geometry);

/// Whether a block of ticks has the joints beyond the sixth as one more column.
bool hasMoreJoints(const Block& ticks);

/// The rows of a block. Lengths come back in m; what the file does not hold keeps its default.
std::vector<servo::TickRecord> unpackTicks(const Block& block);

}  // namespace underact::record
