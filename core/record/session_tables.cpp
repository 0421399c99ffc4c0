#include "core/record/session_tables.h"

#include <algorithm>
#include <cmath>

namespace underact::record {
namespace {

constexpr Column kTick{"tick", "", "number of the tick", Kind::Integer};
constexpr Column kTextAt{"text_at", "", "where its words begin in /text/bytes", Kind::Integer};
constexpr Column kTextBytes{"text_bytes", "", "how many bytes of UTF-8 they are", Kind::Integer};
constexpr Column kFaultKind{
    "kind", "",
    "1 no_sample, 2 stale_sample, 3 not_finite, 4 too_fast, 5 too_late, 6 stood_still, 7 odd_clock, 8 asleep",
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
  return {Table{"ticks", tickColumns(), ticks, ticks, kMostBlockRows},
          Table{"changes", kChangeColumns},
          Table{"markers", kMarkerColumns},
          Table{"faults", kFaultColumns},
          Table{"end", kEndColumns, 1, 1},
          Table{"text", kByteColumns, kTextBlock, 1024},
          Table{"start", kStartColumns, kStartBlock, kStartBlock}};
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

}  // namespace underact::record
