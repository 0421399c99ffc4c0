// What it costs to keep every tick: rows a second, bytes a row, and the longest a block took, for a session and for
// files that are simpler (raw append, CSV) or more (SQLite), in one run on the same ticks; then the servo's lateness
// with and without a recorder. Prints, asserts nothing. Arguments: FOLDER [SECONDS of each lateness run].

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/record/csv.h"
#include "core/record/recorder.h"
#include "core/record/session_writer.h"
#include "core/record/tick_table.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"
#include "device/simulated_arm.h"

#if UNDERACT_HAS_SQLITE
#include <sqlite3.h>
#endif

using namespace underact;
using std::chrono::steady_clock;

namespace {

scene::Description sphere() {
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3(0.0, 0.0, 20.0), 40.0}, target::Side::Both, {}, {}});
  return scene;
}

std::unique_ptr<servo::Host> makeHost(servo::Clock clock, int rate_hz) {
  const sim::HandScript script = sim::builtInHand("probe", 1).value();
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = *sim::findArmModel(sim::kDefaultArmModel);
  options.hand = script.hand;
  options.rate_hz = rate_hz;
  auto arm = std::make_unique<device::SimulatedArm>(options);
  arm->follow(script);
  auto host = std::make_unique<servo::Host>(std::move(arm), servo::HostOptions{.rate_hz = rate_hz, .clock = clock});
  host->load(sphere());
  host->start();
  return host;
}

std::vector<servo::TickRecord> someTicks(std::int64_t count) {
  std::vector<servo::TickRecord> ticks;
  const auto host = makeHost(servo::Clock::Manual, 1000);
  while (static_cast<std::int64_t>(ticks.size()) < count) {
    host->run(1000);
    host->drain([&](const servo::TickRecord& record) { ticks.push_back(record); });
  }
  return ticks;
}

/// Ticks, and how many of them are written at a time: a tenth of a second.
struct Load {
  const std::vector<servo::TickRecord>& ticks;
  std::size_t block = 100;
};

/// Writes all ticks, a block at a time, and prints how that went.
void measure(const char* what, const std::string& path, const Load& load,
             const std::function<void(const servo::TickRecord&)>& row, const std::function<void()>& flush,
             const std::function<void()>& close) {
  double longest_s = 0.0;
  const auto begin = steady_clock::now();
  for (std::size_t first = 0; first < load.ticks.size(); first += load.block) {
    const auto before = steady_clock::now();
    for (std::size_t index = first; index < std::min(load.ticks.size(), first + load.block); ++index)
      row(load.ticks[index]);
    flush();
    longest_s = std::max(longest_s, std::chrono::duration<double>(steady_clock::now() - before).count());
  }
  const double taken_s = std::chrono::duration<double>(steady_clock::now() - begin).count();
  close();
  const auto count = static_cast<double>(load.ticks.size());
  std::printf("%-28s %10.0f rows/s %8.1f bytes/row %9.2f ms the longest block\n", what, count / taken_s,
              static_cast<double>(std::filesystem::file_size(path)) / count, 1e3 * longest_s);
}

void measureSession(const std::string& path, const Load& load) {
  record::SessionHeader header;
  header.rate_hz = static_cast<std::int64_t>(10 * load.block);
  Result<record::SessionWriter> writer = record::SessionWriter::create(path, header);
  writer.value().begin(1, 0, {}, {});
  measure(
      "session (HDF5, SWMR)", path, load, [&](const servo::TickRecord& tick) { writer.value().add(tick); },
      [&] { writer.value().flush(); }, [&] { writer.value().end({}); });
}

void measureRaw(const std::string& path, const Load& load) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  record::Packer packer(record::tickColumns());
  const arm::Geometry geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  packer.begin(static_cast<std::int64_t>(load.block));
  measure(
      "raw append", path, load, [&](const servo::TickRecord& tick) { record::pack(tick, geometry, packer); },
      [&] {
        const record::Block block = packer.block();
        std::fwrite(block.bytes.data(), 1, block.bytes.size(), file);
        std::fflush(file);
        packer.begin(static_cast<std::int64_t>(load.block));
      },
      [&] { std::fclose(file); });
}

void measureCsv(const std::string& path, const Load& load) {
  Result<record::CsvWriter> csv = record::CsvWriter::create(path, system::Existing::ReplaceFile);
  measure(
      "CSV (34 columns)", path, load, [&](const servo::TickRecord& tick) { csv.value().add(tick); }, [] {},
      [&] { csv.value().close(); });
}

#if UNDERACT_HAS_SQLITE
/// The same numbers, a row a tick, a transaction a block. WAL, and synchronous NORMAL or OFF: a kill loses nothing in
/// either, a power cut may with OFF, as with all the others here.
void measureSqlite(const char* what, const char* synchronous, const std::string& path, const Load& load) {
  constexpr int kNumbers = 43;
  sqlite3* base = nullptr;
  sqlite3_open(path.c_str(), &base);
  const auto run = [base](const std::string& sql) { sqlite3_exec(base, sql.c_str(), nullptr, nullptr, nullptr); };
  run("PRAGMA journal_mode=WAL");
  run(std::string("PRAGMA synchronous=") + synchronous);
  std::string columns, marks;
  for (int column = 0; column < kNumbers; ++column) {
    columns += (column > 0 ? ",c" : "c") + std::to_string(column) + " REAL";
    marks += column > 0 ? ",?" : "?";
  }
  run("CREATE TABLE ticks(" + columns + ")");
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(base, ("INSERT INTO ticks VALUES(" + marks + ")").c_str(), -1, &insert, nullptr);
  run("BEGIN");
  measure(
      what, path, load,
      [&](const servo::TickRecord& tick) {
        sqlite3_bind_int64(insert, 1, tick.tick);
        sqlite3_bind_int64(insert, 2, tick.time_ns);
        for (int column = 3; column <= kNumbers; ++column) {
          sqlite3_bind_double(insert, column, tick.q_rad[static_cast<std::size_t>(column % 6)] * column);
        }
        sqlite3_step(insert);
        sqlite3_reset(insert);
      },
      [&] {
        run("COMMIT");
        run("BEGIN");
      },
      [&] {
        run("COMMIT");
        sqlite3_finalize(insert);
        sqlite3_close(base);
      });
}
#endif

void measureLateness(int rate_hz, bool records, double seconds, const std::string& path) {
  const auto host = makeHost(servo::Clock::Thread, rate_hz);
  host->begin();
  std::unique_ptr<record::Recorder> recorder;
  if (records) recorder = record::Recorder::start(*host, path, {}).value();
  const auto end = steady_clock::now() + std::chrono::duration<double>(seconds);
  servo::Histogram lateness;
  while (steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    host->drain([&](const servo::TickRecord& tick) { lateness.add(tick.lateness_ns); });
  }
  const servo::Percentiles p = lateness.percentiles();
  std::printf("%5d Hz %-14s lateness us p50 %6.1f p99 %7.1f p99.9 %8.1f max %9.1f", rate_hz,
              records ? "recorded" : "not recorded", p.p50_us, p.p99_us, p.p999_us, p.max_us);
  if (recorder) {
    recorder->stop();
    std::printf("   %lld ticks, %lld dropped", static_cast<long long>(recorder->status().ticks),
                static_cast<long long>(recorder->status().dropped));
  }
  std::printf("   %s\n", host->scheduling().name.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : std::filesystem::temp_directory_path().string();
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10.0;
  const std::string path = (folder / "underact-record-bench.file").string();
  const std::vector<servo::TickRecord> ticks = someTicks(200'000);
  for (const std::size_t block : {100u, 400u, 1000u}) {
    const Load load{ticks, block};
    std::printf("%zu ticks in blocks of %zu, as at %zu Hz, into %s\n", ticks.size(), block, 10 * block, folder.c_str());
    measureSession(path, load);
    measureRaw(path, load);
    measureCsv(path, load);
    std::filesystem::remove(path);
#if UNDERACT_HAS_SQLITE
    for (const auto& [what, synchronous] :
         {std::pair{"SQLite (WAL, NORMAL)", "NORMAL"}, {"SQLite (WAL, OFF)", "OFF"}}) {
      measureSqlite(what, synchronous, path, load);
      for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(path + end);
    }
#endif
  }
  for (const int rate_hz : {1000, 4000, 10000}) {
    for (int round = 0; round < 2; ++round) {
      measureLateness(rate_hz, false, seconds, path);
      measureLateness(rate_hz, true, seconds, path);
    }
  }
  std::filesystem::remove(path);
  return 0;
}
