#include "core/record/session_tables.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::record {
constexpr std::array kByteColumns{Column{"bytes", "", "UTF-8", NumberKind::Byte}};
constexpr std::array kStartColumns{Column{"bytes", "", "the servo's memory at the first row", NumberKind::Byte}};

// The rows of the longest block at the highest rate of a session.
constexpr std::int64_t kMaxBlockRows = 200'000;
static_assert(kMaxBlockRows >= kLongestBlock_s * 1e6);

std::array<Table, kTables> sessionTables(std::int64_t rate_hz, double block_s) {
  const std::int64_t ticks = std::max<std::int64_t>(std::llround(block_s * static_cast<double>(rate_hz)), 1);
  const auto small = [](const char* name, std::span<const Column> columns, const char* about) {
    return Table{name, columns, 1, 64, 0, Presence::Always, true, about};
  };
  std::array tables{
      Table{"ticks", tickColumns(), ticks, ticks, kMaxBlockRows, Presence::Always, true, "one tick of the servo"},
      small("changes", kColumns<ChangeRow>,
            "a scene that came into effect: the first row is the initial scene, every later edit adds a row"),
      small("markers", kColumns<MarkerRow>, "a marker that somebody set"),
      small("faults", kColumns<servo::FaultMark>, "a fault: the force went to zero"),
      Table{"end", kColumns<EndRow>, 1, 1, 0, Presence::Always, true, "written when the recording ends in order"},
      Table{"text", kByteColumns, kTextBlock, 1024, 0, Presence::Always, true, "one byte of the texts"},
      Table{"start", kStartColumns, kStartBlock, kStartBlock, 0, Presence::Always, true,
            "one byte of the servo's memory at the first row"},
      small("provenance", kColumns<ProvenanceRow>,
            "what was run, as JSON: the first row all of it, a later one what changed"),
      small("clock", kColumns<ClockRow>,
            "the system's clocks at a tick: at the beginning, every ten seconds, at the end"),
      Table{"truth", kColumns<servo::TruthRow>, ticks, ticks, kMaxBlockRows, Presence::OnRequest, false,
            "what the simulated arm knows of a tick and no real arm says"},
      Table{"constraints", kColumns<servo::ConstraintRow>, ticks, ticks, kMaxBlockRows, Presence::OnRequest, false,
            "one constraint in one tick"},
      small("steering", kColumns<SteeringRow>,
            "what a program that steered the servo did besides edits: a force that it added, a target that it carried"),
      Table{"joints", kColumns<JointsRow>, ticks, ticks, kMaxBlockRows, Presence::Later, true,
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

Block textBlock(std::string_view text) {
  Block block;
  block.rows = static_cast<std::int64_t>((text.size() + kTextBlock - 1) / kTextBlock * kTextBlock);
  block.bytes.resize(static_cast<std::size_t>(block.rows));
  std::transform(text.begin(), text.end(), block.bytes.begin(), [](char one) { return static_cast<std::byte>(one); });
  return block;
}

}  // namespace underact::record
