#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/record/table.h"
#include "core/record/tick_table.h"
#include "core/servo/tap.h"

namespace underact::record {

/// The tables of a session, in this order. Layout: resources/guide/session_file.md.
enum TableIndex : std::size_t {
  kTicks,
  kChanges,
  kMarkers,
  kFaults,
  kEnd,
  kText,
  kStart,
  kProvenance,
  kClock,
  kTruth,
  kConstraints,
  kSteering,
  kJoints,
  kTables
};

inline constexpr std::int64_t kSessionVersion = 1;
inline constexpr const char *kServosTime = "servo", *kArmsTime = "arm";  // the attribute gate_time; absent: the arm's
inline constexpr std::int64_t kTextBlock = 64;     // bytes; texts are padded to whole blocks with zeros
inline constexpr std::int64_t kStartBlock = 4096;  // bytes

/// What one session may hold: a reader refuses more, since it keeps the small tables and the labels in memory, and a
/// writer never writes more: it goes on in another session. `log columns` prints them; the Python package follows that.
struct SessionLimits {
  std::int64_t ticks = 1LL << 32;             // 49 days at 1 kHz; with all details still below kLongestFile
  std::int64_t small_rows = 1LL << 20;        // of each table whose rows come one by one
  std::int64_t markers = 1LL << 16;           // fewer: each has a text to be read
  std::int64_t label_bytes = 64LL << 10;      // of one marker
  std::int64_t all_label_bytes = 16LL << 20;  // and of all
  std::int64_t text_bytes = 64LL << 20;       // of a scene, or of what was run
  std::int64_t start_bytes = 16LL << 20;      // of the servo's state
  std::int64_t attribute_bytes = 1LL << 20;   // of a text attribute
  /// The rows of a table; of one without a limit of its own the greatest number.
  std::int64_t rowsOf(TableIndex table) const;
};
inline constexpr SessionLimits kSessionLimits;

// The length of a block of ticks: what is lost at most if the program is killed, besides the time between two runs of
// the recorder. The lab's page has the cost of each length.
inline constexpr double kBlock_s = 0.1, kShortestBlock_s = 0.01, kLongestBlock_s = 0.2;

/// The tables of a session. A block of ticks is block_s long, and one row at least.
std::array<Table, kTables> sessionTables(std::int64_t rate_hz, double block_s = kBlock_s);

/// Why a recording ended.
enum class EndReason : std::uint8_t { Stopped, ProgramEnded, DiskFull, Recovered };
const char* name(EndReason reason);  // "stopped", "program_ended", "disk_full", "recovered"

/// A range of bytes of /text.
struct Words {
  std::int64_t at = 0;
  std::int64_t bytes = 0;
};

/// A row of /changes: from this tick on another scene was in effect.
struct ChangeRow {
  std::int64_t tick = 0;
  std::uint64_t revision = 0;
  tick::Carry carry = tick::Carry::Arm;
  Words scene;
  std::int64_t over_ticks = 0;  // of /steering: over which the targets were carried to their new places; 0: at once
};
/// What somebody did to the servo from outside besides an edit. Push: a force was added before the gate. Move: with the
/// scene of that revision, its targets were carried to their places within so many ticks.
enum class Steering : std::uint8_t { Push = 1, Move = 2 };
/// A row of /steering.
struct SteeringRow {
  std::int64_t tick = 0;
  Steering kind = Steering::Push;
  std::uint64_t revision = 0;  // Move: of the scene
  std::int64_t ticks = 0;
  Vec3 f_T_W = Vec3::Zero();  // Push: N
};
/// A row of /markers.
struct MarkerRow {
  std::int64_t tick = 0;
  Words label;
};
/// A row of /provenance: what was run, and from a later tick on what changed of it, as a JSON object.
struct ProvenanceRow {
  std::int64_t tick = 0;
  Words json;
};
/// A row of /clock: the system's two clocks, read together, when the tick was the newest one.
struct ClockRow {
  std::int64_t tick = 0;
  std::int64_t time_ns = 0;       // the arm's, of that tick's sample
  std::int64_t monotonic_ns = 0;  // the servo's clock, which is not set
  std::int64_t unix_ns = 0;       // since 1970, UTC
  std::int64_t between_ns = 0;    // how long reading the two took
};
/// The row of /end, which a recording that ended in order has.
struct EndRow {
  std::int64_t tick = 0;  // the last one
  std::int64_t dropped = 0;
  std::int64_t unix_ns = 0;
  EndReason reason = EndReason::Stopped;
};

/// A row of /joints: those of the arm in that tick beyond the sixth, 0 where it does not have them.
struct JointsRow {
  std::int64_t tick = 0;
  std::array<double, 2> q{};  // rad, or m where the joint slides
};

/// The text, padded with zeros to whole blocks of kTextBlock.
Block textBlock(std::string_view text);

template <>
inline constexpr std::pair kEnumerators<tick::Carry>{tick::Carry::Arm, tick::Carry::ArmAndMovedLaws};
template <>
inline constexpr std::pair kEnumerators<Steering>{Steering::Push, Steering::Move};
template <>
inline constexpr std::pair kEnumerators<EndReason>{EndReason::Stopped, EndReason::Recovered};

inline constexpr Column kTick{"tick", "", "number of the tick", NumberKind::Integer};
inline constexpr Column kTextAt{"text_at", "", "where its words begin in /text/bytes", NumberKind::Integer};
inline constexpr Column kTextBytes{"text_bytes", "", "how many bytes of UTF-8 they are", NumberKind::Integer};

template <>
inline constexpr std::tuple kFields<ChangeRow>{
    Field{kTick, &ChangeRow::tick},
    Field{Column{"revision", "", "of the scene, from this tick on", NumberKind::Integer}, &ChangeRow::revision},
    Field{Column{"carry", "", "0 the scene was loaded, 1 gains were changed, 2 targets were moved", NumberKind::Byte},
          &ChangeRow::carry},
    Field{kTextAt, within(&ChangeRow::scene, &Words::at)}, Field{kTextBytes, within(&ChangeRow::scene, &Words::bytes)}};
template <>
inline constexpr std::tuple kFields<MarkerRow>{Field{kTick, &MarkerRow::tick},
                                               Field{kTextAt, within(&MarkerRow::label, &Words::at)},
                                               Field{kTextBytes, within(&MarkerRow::label, &Words::bytes)}};
template <>
inline constexpr std::tuple kFields<servo::FaultMark>{
    Field{kTick, &servo::FaultMark::tick},
    Field{Column{"kind", "", kFaultMeaning.substr(kFaultMeaning.find("1 ")), NumberKind::Byte},
          within(&servo::FaultMark::fault, &Fault::kind)},
    Field{Column{"seen", "", "what was measured"}, within(&servo::FaultMark::fault, &Fault::seen)},
    Field{Column{"allowed", "", "what would have been well"}, within(&servo::FaultMark::fault, &Fault::allowed)},
    Field{Column{"from_servo", "", "1: found outside the tick", NumberKind::Byte}, &servo::FaultMark::from_servo}};
template <>
inline constexpr std::tuple kFields<EndRow>{
    Field{kTick, &EndRow::tick},
    Field{Column{"dropped", "", "ticks that are missing", NumberKind::Integer}, &EndRow::dropped},
    Field{Column{"unix_ns", "ns", "the clock at the end, since 1970", NumberKind::Integer}, &EndRow::unix_ns},
    Field{Column{"reason", "", "0 stopped, 1 the program ended, 2 the disk was full, 3 recovered", NumberKind::Byte},
          &EndRow::reason}};
template <>
inline constexpr std::tuple kFields<ProvenanceRow>{Field{kTick, &ProvenanceRow::tick},
                                                   Field{kTextAt, within(&ProvenanceRow::json, &Words::at)},
                                                   Field{kTextBytes, within(&ProvenanceRow::json, &Words::bytes)}};
template <>
inline constexpr std::tuple kFields<ClockRow>{
    Field{kTick, &ClockRow::tick},
    Field{Column{"time_ns", "ns", "of that tick's sample, on the arm's clock", NumberKind::Integer},
          &ClockRow::time_ns},
    Field{Column{"monotonic_ns", "ns", "the servo's clock, which nobody sets", NumberKind::Integer},
          &ClockRow::monotonic_ns},
    Field{Column{"unix_ns", "ns", "the clock at the same moment, since 1970, UTC", NumberKind::Integer},
          &ClockRow::unix_ns},
    Field{Column{"between_ns", "ns", "that reading the two clocks took", NumberKind::Integer}, &ClockRow::between_ns}};
template <>
inline constexpr std::tuple kFields<servo::TruthRow>{
    Field{kTick, &servo::TruthRow::tick},
    Field{Column{"p_true_WT_mm", "mm", "where the simulated arm's tip really is: without encoders", NumberKind::Real,
                 "", 3, "W"},
          within(&servo::TruthRow::truth, &servo::Truth::p_WT), kMillimetrePerMetre},
    Field{Column{"hand_force_N", "N", "force of the simulated hand's spring and damper on the tip at the sample",
                 NumberKind::Real, "", 3, "W"},
          within(&servo::TruthRow::truth, &servo::Truth::f_hand_T_W)}};
template <>
inline constexpr std::tuple kFields<servo::ConstraintRow>{
    Field{kTick, &servo::ConstraintRow::tick},
    Field{Column{"constraint", "", "its index in the scene, from 0", NumberKind::Unsigned},
          &servo::ConstraintRow::constraint},
    Field{Column{"acts", "", "1: it contributes to the force", NumberKind::Byte}, &servo::ConstraintRow::acts},
    Field{Column{"p_WP_mm", "mm", "its target; nan: none", NumberKind::Real, "", 3, "W"}, &servo::ConstraintRow::p_WP,
          kMillimetrePerMetre},
    Field{Column{"force_N", "N", "its own force on the tip, before the gate", NumberKind::Real, "", 3, "W"},
          &servo::ConstraintRow::f_T_W}};
template <>
inline constexpr std::tuple kFields<SteeringRow>{
    Field{kTick, &SteeringRow::tick},
    Field{Column{"kind", "", "1 a force was added before the gate, 2 targets were carried to their places",
                 NumberKind::Byte},
          &SteeringRow::kind},
    Field{Column{"revision", "", "of the scene whose targets were carried; 0: none", NumberKind::Integer},
          &SteeringRow::revision},
    Field{Column{"ticks", "", "how many ticks it took; 0: an added force ended", NumberKind::Integer},
          &SteeringRow::ticks},
    Field{Column{"force_N", "N", "that was added", NumberKind::Real, "", 3, "W"}, &SteeringRow::f_T_W}};
template <>
inline constexpr std::tuple kFields<JointsRow>{Field{kTick, &JointsRow::tick},
                                               Field{kMoreJoints.column, &JointsRow::q}};

}  // namespace underact::record
