#include "core/record/fault_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "core/json/json.h"
#include "core/record/columns.h"
#include "tests/support/full_disk.h"
#include "tests/support/modes.h"

namespace underact::record {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone with the test.
struct Scratch {
  Scratch() : path(fs::temp_directory_path() / ("underact_faults_" + std::to_string(getpid()))) {
    fs::remove_all(path);
  }
  ~Scratch() { fs::remove_all(path); }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) found.push_back(entry.path().filename());
    std::sort(found.begin(), found.end());
    return found;
  }
  fs::path path;
};

servo::FaultReport someFault() {
  servo::FaultReport report;
  report.fault = {FaultKind::TooFast, 1.0 / 3.0, 20.0};
  report.tick = 4321;
  report.unix_time_s = 1'700'000'000;
  report.rate_hz = 1000;
  report.device = {"Arm \"A\"", true, false};
  report.scheduling = {"FIFO 80", "", {"memory locked", "all cores"}};
  report.late.total = 3;
  report.late.by_cause[static_cast<std::size_t>(servo::LateCause::Preempted)] = 2;
  report.late.left_out = 5;
  report.scene.title = "A \\ sphere";
  report.scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  for (std::int64_t tick = 4320; tick <= 4321; ++tick) {
    servo::TickRecord record;
    record.tick = tick;
    record.time_ns = 1'000'000 * tick;
    record.p_WP.setConstant(std::numeric_limits<double>::quiet_NaN());
    record.f_asked_T_W = {1.0 / 3.0, -2.2250738585072014e-308, std::numeric_limits<double>::infinity()};
    record.fault = tick == 4321 ? FaultKind::TooFast : FaultKind::None;
    report.last_second.push_back(record);
  }
  return report;
}

std::string textOf(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

json::Value read(const std::string& text) {
  Result<json::Value> value = json::parse(text, "fault");
  EXPECT_TRUE(value) << describe(value.problems().front());
  return value ? std::move(value).value() : json::Value{};
}

const json::Value& column(const json::Value& fault, std::size_t row, std::string_view name) {
  const json::Value& columns = *fault.find("columns");
  for (std::size_t index = 0; index < columns.items.size(); ++index) {
    if (columns.items[index].text == name) return fault.find("rows")->items.at(row).items.at(index);
  }
  ADD_FAILURE() << "no column " << name;
  return fault;
}

TEST(FaultFile, TimeIsUtcAsIsoWritesIt) {
  EXPECT_EQ(isoTime(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(isoTime(951'782'400), "2000-02-29T00:00:00Z");
  EXPECT_EQ(isoTime(1'700'000'000), "2023-11-14T22:13:20Z");
  EXPECT_EQ(isoTime(-1), "1969-12-31T23:59:59Z");
}

TEST(FaultFile, SaysWhatHappenedWhatToDoAndWhatWasRun) {
  const json::Value fault = read(faultText(someFault(), wordsOf(someFault().fault)));
  EXPECT_EQ(fault.find("underact_fault")->number, 1.0);
  EXPECT_EQ(fault.find("kind")->text, "too_fast");
  EXPECT_EQ(fault.find("what")->text, whatHappened(someFault().fault));
  EXPECT_EQ(fault.find("what_to_do")->text, whatToDo(someFault().fault));
  EXPECT_EQ(fault.find("seen")->number, 1.0 / 3.0);
  EXPECT_EQ(fault.find("allowed")->number, 20.0);
  EXPECT_EQ(fault.find("time")->text, "2023-11-14T22:13:20Z");
  EXPECT_EQ(fault.find("tick")->number, 4321.0);
  EXPECT_EQ(fault.find("rate_hz")->number, 1000.0);
  EXPECT_EQ(fault.find("device")->find("title")->text, "Arm \"A\"");
  EXPECT_TRUE(fault.find("device")->find("simulated")->boolean);
  EXPECT_EQ(fault.find("scheduling")->find("name")->text, "FIFO 80");
  EXPECT_EQ(fault.find("scheduling")->find("also")->items.at(1).text, "all cores");
  EXPECT_EQ(fault.find("late_ticks")->find("total")->number, 3.0);
  EXPECT_EQ(fault.find("late_ticks")->find("preempted")->number, 2.0);
  EXPECT_EQ(fault.find("late_ticks")->find("left_out")->number, 5.0);
  EXPECT_EQ(fault.find("scene")->find("title")->text, "A \\ sphere");
  EXPECT_EQ(fault.find("scene")->find("constraints")->items.at(0).find("radius_mm")->number, 50.0);
}

TEST(FaultFile, ARowHasAFieldForEachColumnAndNumbersReadBackToTheSameDouble) {
  const json::Value fault = read(faultText(someFault(), wordsOf(someFault().fault)));
  ASSERT_EQ(fault.find("columns")->items.size(), csvFields().size());
  ASSERT_EQ(fault.find("rows")->items.size(), 2U);
  for (const json::Value& row : fault.find("rows")->items) EXPECT_EQ(row.items.size(), csvFields().size());
  EXPECT_EQ(column(fault, 1, "tick").number, 4321.0);
  EXPECT_EQ(column(fault, 0, "force_asked_x_N").number, 1.0 / 3.0);
  EXPECT_EQ(column(fault, 0, "force_asked_y_N").number, -2.2250738585072014e-308);
  EXPECT_EQ(column(fault, 0, "force_asked_z_N").kind, json::JsonKind::Null);
  EXPECT_EQ(column(fault, 0, "target_x_mm").kind, json::JsonKind::Null);
  EXPECT_EQ(column(fault, 0, "fault").text, "none");
  EXPECT_EQ(column(fault, 1, "fault").text, "too_fast");
}

TEST(FaultFile, NoTickAtAllIsAnEmptyList) {
  servo::FaultReport report = someFault();
  report.last_second.clear();
  EXPECT_TRUE(read(faultText(report, wordsOf(report.fault))).find("rows")->items.empty());
}

TEST(FaultFile, FaultsOfOneSecondHaveAFileEachAndNothingIsLeftBeside) {
  const Scratch scratch;
  const FaultWords words = wordsOf(someFault().fault);
  const Result<std::string> first = saveFault(someFault(), words, scratch.path / "faults");
  const Result<std::string> second = saveFault(someFault(), {"window", "", ""}, scratch.path / "faults");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(fs::path(first.value()).filename(), "fault_20231114T221320Z_01_too_fast.json");
  EXPECT_EQ(fs::path(second.value()).filename(), "fault_20231114T221320Z_02_window.json");
  EXPECT_EQ(textOf(first.value()), faultText(someFault(), words));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path / "faults"), fs::directory_iterator()), 2);
}

TEST(FaultFile, TheNewestTwentyAreKeptAndWhatIsNotOursIsNotTouched) {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  std::ofstream(scratch.path / "notes.txt") << "mine";
  servo::FaultReport report = someFault();
  for (int fault = 0; fault < 25; ++fault) {
    report.unix_time_s = 1'700'000'000 + 3600 * fault;
    ASSERT_TRUE(saveFault(report, wordsOf(report.fault), scratch.path));
  }
  const std::vector<std::string> names = scratch.names();
  ASSERT_EQ(names.size(), 21U);
  EXPECT_EQ(names.front(), "fault_20231115T031320Z_01_too_fast.json");  // the sixth
  EXPECT_EQ(names.back(), "notes.txt");
}

TEST(FaultFile, AClockThatWasSetBackDoesNotTakeTheNewestAway) {
  const Scratch scratch;
  servo::FaultReport report = someFault();
  for (int fault = 0; fault < 20; ++fault) {
    report.unix_time_s = 1'700'000'000 + fault;
    ASSERT_TRUE(saveFault(report, wordsOf(report.fault), scratch.path));
  }
  report.unix_time_s = 0;
  const Result<std::string> kept = saveFault(report, wordsOf(report.fault), scratch.path);
  ASSERT_TRUE(kept);
  EXPECT_TRUE(fs::exists(kept.value()));
  EXPECT_EQ(scratch.names().size(), 20U);
}

TEST(FaultFile, WhereItCannotBeWrittenIsAProblemThatSaysWhereAndWhy) {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  std::ofstream(scratch.path / "faults") << "a file where the folder would be";
  const Result<std::string> kept = saveFault(someFault(), wordsOf(someFault().fault), scratch.path / "faults");
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.problems()[0].place.file, (scratch.path / "faults").string());
  EXPECT_FALSE(kept.problems()[0].sentence.empty());
}

TEST(FaultFile, AFullDiskIsAProblemAndLeavesNothingBehind) {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  const fs::path path = scratch.path / "fault.json";
  const Problems problems = [&] {
    const test::FullDisk full(1);
    return writeFaultFile("{}", path);
  }();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].sentence.find("File too large"), std::string::npos) << problems[0].sentence;
  EXPECT_TRUE(scratch.names().empty());
}

TEST(FaultFile, IsItsOwnersAloneAndSoIsItsFolderWhateverTheUmaskIs) {
  const Scratch scratch;
  const test::Umask everybody(0);
  const std::string folder = (scratch.path / "made/faults").string();
  const Result<std::string> kept = saveFault(servo::FaultReport{}, {"k", "w", "d"}, folder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(test::modeOf(kept.value()), 0600U);
  EXPECT_EQ(test::modeOf(folder), 0700U);
}

TEST(FaultFile, ALinkAtTheNameOfItsPartIsNotFollowed) {
  const Scratch scratch;
  fs::create_directories(scratch.path);
  const fs::path path = scratch.path / "fault.json", mine = scratch.path / "mine";
  std::ofstream(mine) << "mine";
  fs::create_symlink(mine, path.string() + ".part");
  EXPECT_TRUE(writeFaultFile("{}", path).empty());
  EXPECT_EQ(fs::file_size(mine), 4U);
}

}  // namespace
}  // namespace underact::record
