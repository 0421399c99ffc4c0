#include "core/record/session_tables.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::record {
namespace {

constexpr Column kTick{"tick", "", "number of the tick", Kind::Integer};
constexpr Column kTextAt{"text_at", "", "where its words begin in /text/bytes", Kind::Integer};
constexpr Column kTextBytes{"text_bytes", "", "how many bytes of UTF-8 they are", Kind::Integer};
constexpr Column kFaultKind{"kind", "",
                            "1 no_sample, 2 stale_sample, 3 not_finite, 4 too_fast, 5 too_late, 6 stood_still, 7 "
                            "odd_clock, 8 asleep, 9 window_busy",
                            Kind::Byte};

constexpr std::array kChangeColumns{
    kTick, Column{"revision", "", "of the scene, from this tick on", Kind::Integer},
    Column{"carry", "", "0 the scene was loaded, 1 gains were changed, 2 targets were moved", Kind::Byte}, kTextAt,
    kTextBytes};
constexpr std::array kMarkerColumns{kTick, kTextAt, kTextBytes};
constexpr std::array kFaultColumns{kTick, kFaultKind, Column{"seen", "", "what was measured", Kind::Real},
                                   Column{"allowed", "", "what would have been well", Kind::Real},
                                   Column{"from_servo", "", "1: found outside the tick", Kind::Byte}};
constexpr std::array kEndColumns{
    kTick, Column{"dropped", "", "ticks that are missing", Kind::Integer},
    Column{"unix_ns", "ns", "the clock at the end, since 1970", Kind::Integer},
    Column{"reason", "", "0 stopped, 1 the program ended, 2 the disk was full, 3 recovered", Kind::Byte}};
constexpr std::array kByteColumns{Column{"bytes", "", "UTF-8", Kind::Byte}};
constexpr std::array kStartColumns{Column{"bytes", "", "the servo's memory at the first row", Kind::Byte}};

constexpr std::array kProvenanceColumns{kTick, kTextAt, kTextBytes};
constexpr std::array kClockColumns{
    kTick, Column{"time_ns", "ns", "of that tick's sample, on the arm's clock", Kind::Integer},
    Column{"monotonic_ns", "ns", "the servo's clock, which nobody sets", Kind::Integer},
    Column{"unix_ns", "ns", "the clock at the same moment, since 1970, UTC", Kind::Integer},
    Column{"between_ns", "ns", "that reading the two clocks took", Kind::Integer}};
constexpr std::array kTruthColumns{
    kTick,
    Column{"p_true_WT_mm", "mm", "where the simulated arm's tip really is: without encoders", Kind::Real, 3, "W",
           "p_true_WT_mm_x,p_true_WT_mm_y,p_true_WT_mm_z"},
    Column{"hand_force_N", "N", "force of the simulated hand's spring and damper on the tip at the sample", Kind::Real,
           3, "W", "hand_force_N_x,hand_force_N_y,hand_force_N_z"}};
constexpr std::array kConstraintColumns{
    kTick, Column{"constraint", "", "its index in the scene, from 0", Kind::Unsigned},
    Column{"acts", "", "1: it contributes to the force", Kind::Byte},
    Column{"p_WP_mm", "mm", "its target; nan: none", Kind::Real, 3, "W", "p_WP_mm_x,p_WP_mm_y,p_WP_mm_z"},
    Column{"force_N", "N", "its own force on the tip, before the gate", Kind::Real, 3, "W",
           "force_N_x,force_N_y,force_N_z"}};

constexpr std::array kSteeringColumns{
    kTick,
    Column{"kind", "", "1 a force was added before the gate, 2 targets were carried to their places", Kind::Byte},
    Column{"revision", "", "of the scene whose targets were carried; 0: none", Kind::Integer},
    Column{"ticks", "", "how many ticks it took; 0: an added force ended", Kind::Integer},
    Column{"force_N", "N", "that was added", Kind::Real, 3, "W", "force_N_x,force_N_y,force_N_z"}};

constexpr std::array kJointColumns{
    kTick, Column{"q_more_rad", "rad", "joint angles 7 and 8, of an arm that has them; m where a joint slides",
                  Kind::Real, 2, "joints", "q7_rad,q8_rad", "q7_rad,q8_rad"}};

void packVec3Row(const Vec3& value, double scale, Packer& packer) {
  for (const double coordinate : value) packer.real(scale * coordinate);
}

Vec3 unpackVec3Row(Unpacker& unpacker, double scale) {
  Vec3 value;
  for (double& coordinate : value) coordinate = unpacker.real() / scale;
  return value;
}

template <class Fill>
Block rowOf(std::span<const Column> columns, Fill&& fill) {
  Packer packer(columns);
  packer.begin(1);
  fill(packer);
  return packer.block();
}

template <class Row, class Take>
std::vector<Row> rowsOf(std::span<const Column> columns, const Block& block, Take&& take) {
  std::vector<Row> rows;
  for (Unpacker unpacker(columns, block); !unpacker.isDone();) rows.push_back(take(unpacker));
  return rows;
}

template <class Enumeration>
Enumeration enumerated(std::uint8_t value, int count) {
  return value < count ? static_cast<Enumeration>(value) : Enumeration{};
}

void packWords(const Words& words, Packer& packer) {
  packer.integer(words.at);
  packer.integer(words.bytes);
}

Words unpackWords(Unpacker& unpacker) {
  const std::int64_t at = unpacker.integer();
  return {at, unpacker.integer()};
}

}  // namespace

// The rows of the longest block at the highest rate of a session.
constexpr std::int64_t kMostBlockRows = 200'000;
static_assert(kMostBlockRows >= kLongestBlock_s * 1e6);

std::array<Table, kTables> sessionTables(std::int64_t rate_hz, double block_s) {
  const std::int64_t ticks = std::max<std::int64_t>(std::llround(block_s * static_cast<double>(rate_hz)), 1);
  const auto small = [](const char* name, std::span<const Column> columns, const char* about) {
    return Table{name, columns, 1, 64, 0, Presence::Always, true, about};
  };
  std::array tables{
      Table{"ticks", tickColumns(), ticks, ticks, kMostBlockRows, Presence::Always, true, "one tick of the servo"},
      small("changes", kChangeColumns,
            "a scene that came into effect: the first row is the initial scene, every later edit adds a row"),
      small("markers", kMarkerColumns, "a marker that somebody set"),
      small("faults", kFaultColumns, "a fault: the force went to zero"),
      Table{"end", kEndColumns, 1, 1, 0, Presence::Always, true, "written when the recording ends in order"},
      Table{"text", kByteColumns, kTextBlock, 1024, 0, Presence::Always, true, "one byte of the texts"},
      Table{"start", kStartColumns, kStartBlock, kStartBlock, 0, Presence::Always, true,
            "one byte of the servo's memory at the first row"},
      small("provenance", kProvenanceColumns,
            "what was run, as JSON: the first row all of it, a later one what changed"),
      small("clock", kClockColumns, "the system's clocks at a tick: at the beginning, every ten seconds, at the end"),
      Table{"truth", kTruthColumns, ticks, ticks, kMostBlockRows, Presence::OnRequest, false,
            "what the simulated arm knows of a tick and no real arm says"},
      Table{"constraints", kConstraintColumns, ticks, ticks, kMostBlockRows, Presence::OnRequest, false,
            "one constraint in one tick"},
      small("steering", kSteeringColumns,
            "what a program that steered the servo did besides edits: a force that it added, a target that it carried"),
      Table{"joints", kJointColumns, ticks, ticks, kMostBlockRows, Presence::Later, true,
            "one tick of the servo, of a session with an arm of more than six joints"}};
  tables[kProvenance].presence = tables[kClock].presence = tables[kSteering].presence = Presence::Later;
  return tables;
}

std::int64_t SessionLimits::rowsOf(TableIndex table) const {
  switch (table) {
    case kTicks:
      return ticks;
    case kMarkers:
      return markers;
    case kStart:
      return start_bytes;
    case kText:  // adjacent texts, each with its own limit
    case kTruth:
    case kConstraints:
    case kJoints:  // read block by block, as /ticks, whose limit ends them, too
    case kTables:
      return INT64_MAX;
    default:
      return small_rows;
  }
}

const char* name(EndReason reason) {
  switch (reason) {
    case EndReason::Stopped:
      return "stopped";
    case EndReason::ProgramEnded:
      return "program_ended";
    case EndReason::DiskFull:
      return "disk_full";
    case EndReason::Recovered:
      return "recovered";
  }
  return "";
}

Block blockOf(const ChangeRow& row) {
  return rowOf(kChangeColumns, [&row](Packer& packer) {
    packer.integer(row.tick);
    packer.integer(static_cast<std::int64_t>(row.revision));
    packer.byte(static_cast<std::uint8_t>(row.carry));
    packWords(row.scene, packer);
  });
}

Block blockOf(const MarkerRow& row) {
  return rowOf(kMarkerColumns, [&row](Packer& packer) {
    packer.integer(row.tick);
    packWords(row.label, packer);
  });
}

Block blockOf(const SteeringRow& row) {
  return rowOf(kSteeringColumns, [&row](Packer& packer) {
    packer.integer(row.tick);
    packer.byte(static_cast<std::uint8_t>(row.kind));
    packer.integer(static_cast<std::int64_t>(row.revision));
    packer.integer(row.ticks);
    packVec3Row(row.f_T_W, 1.0, packer);
  });
}

Block blockOf(const ProvenanceRow& row) {
  return rowOf(kProvenanceColumns, [&row](Packer& packer) {
    packer.integer(row.tick);
    packWords(row.json, packer);
  });
}

Block blockOf(const ClockRow& row) {
  return rowOf(kClockColumns, [&row](Packer& packer) {
    for (const std::int64_t number : {row.tick, row.time_ns, row.monotonic_ns, row.unix_ns, row.between_ns})
      packer.integer(number);
  });
}

void pack(const servo::TruthRow& row, Packer& packer) {
  packer.integer(row.tick);
  packVec3Row(row.truth.p_WT, kMillimetrePerMetre, packer);
  packVec3Row(row.truth.f_hand_T_W, 1.0, packer);
}

void pack(const servo::ConstraintRow& row, Packer& packer) {
  packer.integer(row.tick);
  packer.unsigned32(row.constraint);
  packer.byte(row.acts ? 1 : 0);
  packVec3Row(row.p_WP, kMillimetrePerMetre, packer);
  packVec3Row(row.f_T_W, 1.0, packer);
}

std::span<const Column> jointColumns() {
  return kJointColumns;
}

void packMoreJoints(const servo::TickRecord& record, Packer& packer) {
  packer.integer(record.tick);
  for (const double angle_rad : arm::beyondSix(record.q_rad)) packer.real(angle_rad);
}

std::vector<JointsRow> unpackJoints(const Block& block) {
  return rowsOf<JointsRow>(kJointColumns, block, [](Unpacker& unpacker) {
    JointsRow row;
    row.tick = unpacker.integer();
    for (double& value : row.q) value = unpacker.real();
    return row;
  });
}

Block blockOf(const servo::FaultMark& row) {
  return rowOf(kFaultColumns, [&row](Packer& packer) {
    packer.integer(row.tick);
    packer.byte(static_cast<std::uint8_t>(row.fault.kind));
    packer.real(row.fault.seen);
    packer.real(row.fault.allowed);
    packer.byte(row.from_servo ? 1 : 0);
  });
}

Block blockOf(const EndRow& row) {
  return rowOf(kEndColumns, [&row](Packer& packer) {
    packer.integer(row.tick);
    packer.integer(row.dropped);
    packer.integer(row.unix_ns);
    packer.byte(static_cast<std::uint8_t>(row.reason));
  });
}

Block textBlock(std::string_view text) {
  Block block;
  block.rows = static_cast<std::int64_t>((text.size() + kTextBlock - 1) / kTextBlock * kTextBlock);
  block.bytes.resize(static_cast<std::size_t>(block.rows));
  std::transform(text.begin(), text.end(), block.bytes.begin(), [](char one) { return static_cast<std::byte>(one); });
  return block;
}

std::vector<ChangeRow> unpackChanges(const Block& block) {
  return rowsOf<ChangeRow>(kChangeColumns, block, [](Unpacker& unpacker) {
    ChangeRow row;
    row.tick = unpacker.integer();
    row.revision = static_cast<std::uint64_t>(unpacker.integer());
    row.carry = enumerated<tick::Carry>(unpacker.byte(), 3);
    row.scene = unpackWords(unpacker);
    return row;
  });
}

std::vector<MarkerRow> unpackMarkers(const Block& block) {
  return rowsOf<MarkerRow>(kMarkerColumns, block, [](Unpacker& unpacker) {
    const std::int64_t tick = unpacker.integer();
    return MarkerRow{tick, unpackWords(unpacker)};
  });
}

std::vector<SteeringRow> unpackSteering(const Block& block) {
  return rowsOf<SteeringRow>(kSteeringColumns, block, [](Unpacker& unpacker) {
    SteeringRow row;
    row.tick = unpacker.integer();
    row.kind = unpacker.byte() == static_cast<std::uint8_t>(Steering::Move) ? Steering::Move : Steering::Push;
    row.revision = static_cast<std::uint64_t>(unpacker.integer());
    row.ticks = unpacker.integer();
    row.f_T_W = unpackVec3Row(unpacker, 1.0);
    return row;
  });
}

std::vector<servo::FaultMark> unpackFaults(const Block& block) {
  return rowsOf<servo::FaultMark>(kFaultColumns, block, [](Unpacker& unpacker) {
    servo::FaultMark row;
    row.tick = unpacker.integer();
    row.fault.kind = enumerated<FaultKind>(unpacker.byte(), kFaultKinds);
    row.fault.seen = unpacker.real();
    row.fault.allowed = unpacker.real();
    row.from_servo = unpacker.byte() != 0;
    return row;
  });
}

std::vector<EndRow> unpackEnd(const Block& block) {
  return rowsOf<EndRow>(kEndColumns, block, [](Unpacker& unpacker) {
    EndRow row;
    row.tick = unpacker.integer();
    row.dropped = unpacker.integer();
    row.unix_ns = unpacker.integer();
    row.reason = enumerated<EndReason>(unpacker.byte(), 4);
    return row;
  });
}

std::vector<ProvenanceRow> unpackProvenance(const Block& block) {
  return rowsOf<ProvenanceRow>(kProvenanceColumns, block, [](Unpacker& unpacker) {
    const std::int64_t tick = unpacker.integer();
    return ProvenanceRow{tick, unpackWords(unpacker)};
  });
}

std::vector<ClockRow> unpackClock(const Block& block) {
  return rowsOf<ClockRow>(kClockColumns, block, [](Unpacker& unpacker) {
    ClockRow row;
    for (std::int64_t* const number : {&row.tick, &row.time_ns, &row.monotonic_ns, &row.unix_ns, &row.between_ns})
      *number = unpacker.integer();
    return row;
  });
}

std::vector<servo::TruthRow> unpackTruth(const Block& block) {
  return rowsOf<servo::TruthRow>(kTruthColumns, block, [](Unpacker& unpacker) {
    servo::TruthRow row;
    row.tick = unpacker.integer();
    row.truth.p_WT = unpackVec3Row(unpacker, kMillimetrePerMetre);
    row.truth.f_hand_T_W = unpackVec3Row(unpacker, 1.0);
    return row;
  });
}

std::vector<servo::ConstraintRow> unpackConstraints(const Block& block) {
  return rowsOf<servo::ConstraintRow>(kConstraintColumns, block, [](Unpacker& unpacker) {
    servo::ConstraintRow row;
    row.tick = unpacker.integer();
    row.constraint = unpacker.unsigned32();
    row.acts = unpacker.byte() != 0;
    row.p_WP = unpackVec3Row(unpacker, kMillimetrePerMetre);
    row.f_T_W = unpackVec3Row(unpacker, 1.0);
    return row;
  });
}

}  // namespace underact::record
