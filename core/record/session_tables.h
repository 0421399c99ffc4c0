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

// One row, packed as a block of its table.
Block blockOf(const ChangeRow& row);
Block blockOf(const MarkerRow& row);
Block blockOf(const SteeringRow& row);
Block blockOf(const ProvenanceRow& row);
Block blockOf(const ClockRow& row);
Block blockOf(const servo::FaultMark& row);
Block blockOf(const EndRow& row);
/// The text, padded with zeros to whole blocks of kTextBlock.
Block textBlock(std::string_view text);

// The rows of a whole block; a value outside an enumeration is read as its first one.
std::vector<ChangeRow> unpackChanges(const Block& block);
std::vector<MarkerRow> unpackMarkers(const Block& block);
std::vector<SteeringRow> unpackSteering(const Block& block);
std::vector<servo::FaultMark> unpackFaults(const Block& block);
std::vector<EndRow> unpackEnd(const Block& block);
std::vector<ProvenanceRow> unpackProvenance(const Block& block);
std::vector<ClockRow> unpackClock(const Block& block);
std::vector<servo::TruthRow> unpackTruth(const Block& block);
std::vector<servo::ConstraintRow> unpackConstraints(const Block& block);
// For a Packer of that table's columns.
void pack(const servo::TruthRow& row, Packer& packer);
void pack(const servo::ConstraintRow& row, Packer& packer);
/// The joints beyond the sixth.
void packMoreJoints(const servo::TickRecord& record, Packer& packer);
/// A row of /joints: those of the arm in that tick beyond the sixth, 0 where it does not have them.
struct JointsRow {
  std::int64_t tick = 0;
  std::array<double, 2> q{};  // rad, or m where the joint slides
};
/// A block of /joints, row by row.
std::vector<JointsRow> unpackJoints(const Block& block);
/// The columns of /joints.
std::span<const Column> jointColumns();

}  // namespace underact::record
