#include "core/record/csv.h"

#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/record/columns.h"
#include "tests/support/full_disk.h"
#include "tests/support/property.h"

namespace underact::record {
namespace {

std::string scratch(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("underact_csv_" + std::to_string(getpid()) + "_" + name);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::stringstream stream(line + ",");
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// The lines of the file that the records make, each split into its fields.
std::vector<std::vector<std::string>> written(const std::vector<servo::TickRecord>& records, const std::string& name) {
  const std::string path = scratch(name);
  CsvWriter writer = CsvWriter::create(path, system::Existing::ReplaceFile).value();
  for (const servo::TickRecord& record : records) writer.add(record);
  EXPECT_TRUE(writer.close().empty());
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) rows.push_back(split(line));
  std::filesystem::remove(path);
  return rows;
}

std::string field(const std::vector<std::vector<std::string>>& rows, std::size_t row, const std::string& column) {
  for (std::size_t index = 0; index < rows[0].size(); ++index) {
    if (rows[0][index] == column) return rows[row].at(index);
  }
  return "no column " + column;
}

double number(const std::string& text) {
  double value = kNotANumber;
  const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ptr == text.data() + text.size() ? value : kNotANumber;
}

servo::TickRecord someTick() {
  servo::TickRecord record;
  record.tick = 7;
  record.time_ns = 7'000'000;
  record.q_rad = {0.1, 0.2, 0.3, -0.4, 0.5, 0.6};
  record.p_WT = {0.001, -0.002, 0.0625};
  record.p_WP = {0.003, 0.0, 0.0};
  record.error_m = 0.0005;
  record.f_asked_T_W = {1.0 / 3.0, 0.0, -2.0};
  record.f_sent_T_W = {0.125, 0.0, -0.75};
  record.level = 0.5;
  record.cut_N = 1.25;
  record.fault = FaultKind::NoSample;
  record.angles = {-3.125, 1.0 / 3.0, 0.75};
  record.lateness_ns = 12'345;
  record.tick_ns = 250;
  record.buttons = 3;
  record.revision = 2;
  record.limits = safety::kClampBit | safety::kSlewBit;
  record.energy_J = 0.25;
  record.passive_N = 0.0625;
  return record;
}

TEST(CsvWriter, ARowHasAFieldForEachColumnOfTheHeader) {
  const auto rows = written({someTick(), someTick()}, "columns");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].size(), csvFields().size());
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
}

TEST(CsvWriter, ValuesStandUnderTheirNamesInTheUnitsTheNamesSay) {
  const auto rows = written({someTick()}, "units");
  EXPECT_EQ(field(rows, 1, "tick"), "7");
  EXPECT_EQ(number(field(rows, 1, "time_s")), 0.007);
  EXPECT_EQ(number(field(rows, 1, "q4_rad")), -0.4);
  EXPECT_EQ(number(field(rows, 1, "z_mm")), 62.5);
  EXPECT_EQ(number(field(rows, 1, "target_x_mm")), 3.0);
  EXPECT_EQ(number(field(rows, 1, "error_mm")), 0.5);
  EXPECT_EQ(number(field(rows, 1, "force_asked_z_N")), -2.0);
  EXPECT_EQ(number(field(rows, 1, "force_sent_x_N")), 0.125);
  EXPECT_EQ(number(field(rows, 1, "gate_level")), 0.5);
  EXPECT_EQ(number(field(rows, 1, "cut_N")), 1.25);
  EXPECT_EQ(field(rows, 1, "fault"), "no_sample");
  EXPECT_EQ(number(field(rows, 1, "alpha_rad")), -3.125);
  EXPECT_EQ(number(field(rows, 1, "beta_rad")), 1.0 / 3.0);
  EXPECT_EQ(number(field(rows, 1, "theta_rad")), 0.75);
  EXPECT_DOUBLE_EQ(number(field(rows, 1, "lateness_us")), 12.345);
  EXPECT_EQ(number(field(rows, 1, "tick_us")), 0.25);
  EXPECT_EQ(field(rows, 1, "buttons"), "3");
  EXPECT_EQ(field(rows, 1, "revision"), "2");
  EXPECT_EQ(field(rows, 1, "limits"), "17");
  EXPECT_EQ(number(field(rows, 1, "energy_mJ")), 250.0);
  EXPECT_EQ(number(field(rows, 1, "passive_N")), 0.0625);
}

TEST(CsvWriter, NumbersReadBackToTheSameDouble) {
  test::Random random(test::Seed{20240301});
  std::vector<servo::TickRecord> records(200, someTick());
  for (servo::TickRecord& record : records) {
    record.f_asked_T_W = std::pow(10.0, random.between(-300, 300)) * random.direction();
  }
  const auto rows = written(records, "round_trip");
  ASSERT_EQ(rows.size(), records.size() + 1);
  for (std::size_t index = 0; index < records.size(); ++index) {
    EXPECT_EQ(number(field(rows, index + 1, "force_asked_x_N")), records[index].f_asked_T_W.x());
    EXPECT_EQ(number(field(rows, index + 1, "force_asked_y_N")), records[index].f_asked_T_W.y());
  }
}

TEST(CsvWriter, ATargetThatIsNotThereIsAnEmptyField) {
  servo::TickRecord record = someTick();
  record.p_WP.setConstant(kNotANumber);
  const auto rows = written({record}, "empty");
  EXPECT_EQ(field(rows, 1, "target_x_mm"), "");
  EXPECT_EQ(field(rows, 1, "target_z_mm"), "");
  record.angles = {};
  EXPECT_EQ(field(written({record}, "no_angles"), 1, "theta_rad"), "");
  EXPECT_EQ(rows[1].size(), rows[0].size());
}

TEST(CsvWriter, TheLongestNumbersFitARow) {
  servo::TickRecord record = someTick();
  const double longest = -2.2250738585072014e-308;
  record.q_rad.fill(longest);
  record.p_WT.setConstant(longest);
  record.p_WP.setConstant(longest);
  record.error_m = record.level = record.cut_N = record.energy_J = record.passive_N = longest;
  record.f_asked_T_W.setConstant(longest);
  record.f_sent_T_W.setConstant(longest);
  record.angles = {longest, longest, longest};
  record.tick = record.time_ns = record.lateness_ns = record.tick_ns = std::numeric_limits<std::int64_t>::min();
  record.revision = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(written({record}, "longest")[1].size(), csvFields().size());
}

TEST(CsvWriter, AFullDiskIsToldAtTheEnd) {
  const std::string path = scratch("full.csv");
  {
    const test::FullDisk full(4096);
    Result<CsvWriter> writer = CsvWriter::create(path, system::Existing::ReplaceFile);
    ASSERT_TRUE(writer);
    for (int tick = 0; tick < 1000; ++tick) writer.value().add(someTick());
    const Problems problems = writer.value().close();
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems[0].sentence.find("File too large"), std::string::npos) << problems[0].sentence;
    EXPECT_EQ(problems[0].place.file, path);
    EXPECT_TRUE(writer.value().close().empty());
  }
  std::filesystem::remove(path);
}

TEST(CsvWriter, AFileThatCannotBeMadeIsAProblemWithItsReason) {
  const Result<CsvWriter> writer = CsvWriter::create("/dev/null/nowhere/all.csv", system::Existing::ReplaceFile);
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.problems()[0].sentence.find("Not a directory"), std::string::npos);
}

}  // namespace
}  // namespace underact::record
