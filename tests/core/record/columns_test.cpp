#include "core/record/columns.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "core/json/json.h"
#include "core/record/columns_text.h"
#include "core/record/session_tables.h"
#include "core/record/tick_table.h"

namespace underact::record {
namespace {

// The header of a CSV recording is a promise: names and order of version 0.1.0, and new ones behind them.
constexpr std::string_view kPromised =
    "tick,time_s,q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad,x_mm,y_mm,z_mm,target_x_mm,target_y_mm,"
    "target_z_mm,error_mm,force_asked_x_N,force_asked_y_N,force_asked_z_N,force_sent_x_N,force_sent_y_N,"
    "force_sent_z_N,gate_level,cut_N,fault,alpha_rad,beta_rad,theta_rad,lateness_us,tick_us,buttons,"
    "revision,limits,energy_mJ,passive_N,";

/// The numbers of a row as fillRow() gives them; for a word none.
struct Numbers {
  std::vector<double> values;
  template <class Integer>
  void integer(Integer value) {
    values.push_back(static_cast<double>(value));
  }
  void number(double value) { values.push_back(value); }
  void word(FaultKind) { values.push_back(kNotANumber); }
};

/// A tick of which every number is another one.
servo::TickRecord unequal() {
  servo::TickRecord record;
  record.tick = 7;
  record.time_ns = 1'234'000'000;
  for (std::size_t joint = 0; joint < 6; ++joint) record.q_rad[joint] = 0.25 + static_cast<double>(joint);
  record.buttons = 3;
  record.p_WT = {0.5, 0.25, 0.125};
  record.p_WP = {0.75, 1.25, 2.5};
  record.v_WT = {3.5, 4.5, 5.5};
  record.error_m = 0.0625;
  record.f_asked_T_W = {11, 12, 13};
  record.f_sent_T_W = {14, 15, 16};
  record.level = 0.875;
  record.cut_N = 17;
  record.limits = 18;
  record.angles = {0.1, 0.2, 0.3};
  record.energy_J = 19;
  record.passive_N = 20;
  record.lateness_ns = 21'000;
  record.tick_ns = 22'000;
  record.revision = 23;
  record.input = 1;
  return record;
}

Block blockOfTick(const servo::TickRecord& record) {
  Packer packer(tickColumns(true));
  packer.begin(1);
  pack(record, arm::findPreset(arm::kDefaultArm)->geometry, packer, true);
  return packer.block();
}

/// The number of a column in a block of one tick.
double numberOf(const Block& block, const Column& wanted, std::size_t part) {
  std::size_t at = 0;
  for (const Column& column : tickColumns(true)) {
    const std::byte* const from = block.bytes.data() + at;
    at += bytesOf(column);
    if (&column != &wanted) continue;
    const auto read = [from, part](auto number) {
      std::memcpy(&number, from + part * sizeof number, sizeof number);
      return static_cast<double>(number);
    };
    switch (column.kind) {
      case NumberKind::Byte:
        return read(std::uint8_t{});
      case NumberKind::Unsigned:
        return read(std::uint32_t{});
      case NumberKind::Integer:
        return read(std::int64_t{});
      case NumberKind::Real:
        return read(0.0);
    }
  }
  return kNotANumber;
}

TEST(Columns, CsvKeepsItsNamesInTheirOrder) {
  std::string header;
  for (const CsvField& field : csvFields()) header += field.name + ",";
  EXPECT_TRUE(header.starts_with(kPromised)) << header;
}

TEST(Columns, OfEveryTableHaveAPartForEachNumberAndAMeaning) {
  std::set<std::string_view> tables;
  for (const Table& table : sessionTables(1000)) {
    EXPECT_TRUE(tables.insert(table.name).second) << table.name;
    EXPECT_FALSE(table.about.empty()) << table.name;
    for (const Column& column : table.columns) {
      EXPECT_EQ(partsOf(column).size(), static_cast<std::size_t>(column.width)) << column.name;
      EXPECT_FALSE(column.meaning.empty()) << column.name;
      const std::size_t csv = csvNamesOf(column).size();
      EXPECT_TRUE(csv == 0 || csv == static_cast<std::size_t>(column.width)) << column.name;
      if (column.unit.empty()) continue;  // the name ends in the unit, as everywhere
      std::string ending = "_" + std::string(column.unit);
      if (const std::size_t slash = ending.find('/'); slash != std::string::npos) ending.replace(slash, 1, "_per_");
      EXPECT_TRUE(column.name.ends_with(ending)) << column.name;
    }
  }
}

TEST(Columns, CsvHasTheNumbersOfTheFileInTheFieldsThatTheTableNames) {
  const servo::TickRecord record = unequal();
  const Block block = blockOfTick(record);
  Numbers numbers;
  fillRow(record, numbers);
  const std::span<const CsvField> fields = csvFields();
  ASSERT_EQ(numbers.values.size(), fields.size());
  for (std::size_t index = 0; index < fields.size(); ++index) {
    if (fields[index].type == "string") continue;
    const double scale = fields[index].name == "time_s" ? 1e-9 : 1.0;
    EXPECT_DOUBLE_EQ(numbers.values[index], scale * numberOf(block, *fields[index].column, fields[index].part))
        << fields[index].name;
  }
}

TEST(Columns, OfATickAreReadBackAndServedAsTheyWerePacked) {
  servo::TickRecord record = unequal();
  record.fault = FaultKind::TooLate;
  record.q_rad[7] = 24.0;
  const Block block = blockOfTick(record);
  const servo::TickRecord again = unpackTicks(block).front();
  EXPECT_EQ(blockOfTick(again).bytes, block.bytes);
  EXPECT_EQ(again.q_rad, record.q_rad);
  const std::vector<double> numbers = numbersOf(record, arm::findPreset(arm::kDefaultArm)->geometry);
  std::size_t next = 0;
  for (const Column& column : tickColumns(true)) {
    for (std::size_t part = 0; part < static_cast<std::size_t>(column.width); ++part)
      EXPECT_EQ(numbers[next++], numberOf(block, column, part)) << column.name;
  }
  EXPECT_EQ(next, numbers.size());
}

TEST(Columns, SayTheWordOfEachFault) {
  for (int kind = 0; kind < kFaultKinds; ++kind) {
    const std::string words = std::to_string(kind) + " " + name(static_cast<FaultKind>(kind));
    EXPECT_NE(kFaultMeaning.find(words), std::string_view::npos) << words;
  }
}

TEST(Columns, OfATableAreReadBackAndTakeNoValueOutsideAnEnumeration) {
  SteeringRow steering{5, Steering::Move, 6, 7, {1, 2, 3}};
  EXPECT_EQ(unpack<SteeringRow>(blockOf(steering)).front().kind, Steering::Move);
  Block block = blockOf(steering);
  block.bytes[8] = std::byte{3};
  EXPECT_EQ(unpack<SteeringRow>(block).front().kind, Steering::Push);
  block = blockOf(servo::FaultMark{8, {FaultKind::WindowBusy, 2.0, 1.0}, true});
  EXPECT_EQ(unpack<servo::FaultMark>(block).front().fault.kind, FaultKind::WindowBusy);
  block.bytes[8] = std::byte{kFaultKinds};
  EXPECT_EQ(unpack<servo::FaultMark>(block).front().fault.kind, FaultKind::None);
  EXPECT_EQ(unpack<servo::FaultMark>(block).front().fault.allowed, 1.0);
}

TEST(Columns, AreJsonAndAPage) {
  const Result<json::Value> table = json::parse(columnsJson(), "columns");
  ASSERT_TRUE(table);
  EXPECT_EQ(table.value().find("tables")->items.size(), std::size_t{kTables});
  EXPECT_EQ(table.value().find("csv")->items.size(), csvFields().size());
  const std::string page = columnsPage();
  for (const Table& one : sessionTables(1000)) {
    EXPECT_NE(page.find("## /" + std::string(one.name) + "\n"), std::string::npos) << one.name;
    for (const Column& column : one.columns)
      EXPECT_NE(page.find("| `" + std::string(column.name) + "` |"), std::string::npos) << column.name;
  }
}

}  // namespace
}  // namespace underact::record
