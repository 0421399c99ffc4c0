// Recorded sessions that are damaged in every way, by chance and on purpose, where the checksums of what was changed
// are put right again: read as the programs read them, in a reader of its own that is shut off.
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/record/csv.h"
#include "core/record/recorder.h"
#include "core/record/replay.h"
#include "device/recorded.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

using record::Block;
using record::Hdf5File;
using record::Session;
using record::Table;

constexpr const char* kTexts[] = {"program_version", "name",      "notes",     "tags",       "subject",
                                  "scene_title",     "arm",       "device",    "scheduling", "start_layout",
                                  "consent",         "gate_time", "session_id"};
constexpr const char* kIntegers[] = {"underact_session", "started_unix_ns", "rate_hz", "max_late"};
// As one answer of the reader may take; on a quiet machine a file takes tenths of a second.
constexpr double kLongest_s = 30.0;

std::string bytesAt(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void writeAt(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// All that a file holds, to be written anew by the program's own writer, which makes every checksum.
struct Parts {
  std::vector<record::Attribute> attributes;
  std::array<Table, record::kTables> tables = record::sessionTables(1000);
  std::array<std::vector<Block>, record::kTables> blocks;
};

Parts partsOf(const std::string& path) {
  Parts parts;
  Hdf5File file = Hdf5File::open(path, parts.tables).value();
  for (const char* name : kTexts) parts.attributes.push_back({name, file.text(name)});
  for (const char* name : kIntegers) parts.attributes.push_back({name, file.integer(name, 0)});
  parts.attributes.push_back({"frozen_s", file.real("frozen_s", 0.0)});
  parts.attributes.push_back({"force_share", file.real("force_share", 1.0)});
  for (std::size_t table = 0; table < record::kTables; ++table)
    parts.blocks[table] = file.read(table, 0, 1 << 20).value();
  return parts;
}

void writeParts(const std::string& path, const Parts& parts) {
  Hdf5File file = Hdf5File::create(path, parts.attributes, parts.tables, system::Existing::Replace).value();
  for (std::size_t table = 0; table < record::kTables; ++table) {
    for (const Block& block : parts.blocks[table]) (void)file.append(table, block);
  }
  (void)file.close();
}

/// Eight bytes that no writer would write there.
std::uint64_t oddNumber(Random& random) {
  constexpr double kReals[] = {kNotANumber, kInfinity, -kInfinity, 1e308, -1e308, 5e-324, 0.0};
  constexpr std::int64_t kWholes[] = {INT64_MAX, INT64_MIN, -1, 0, 1, 1LL << 40, INT32_MAX, INT32_MIN};
  std::uint64_t bits = random.bits();
  if (random.below(3) == 0) std::memcpy(&bits, &kReals[random.below(std::size(kReals))], sizeof bits);
  if (random.below(3) == 0) std::memcpy(&bits, &kWholes[random.below(std::size(kWholes))], sizeof bits);
  return bits;
}

void changeBlocks(Random& random, Parts& parts) {
  constexpr std::size_t kOften[] = {record::kStart, record::kStart,      record::kStart,   record::kChanges,
                                    record::kTicks, record::kText,       record::kMarkers, record::kFaults,
                                    record::kEnd,   record::kProvenance, record::kClock};
  std::vector<Block>& blocks = parts.blocks[kOften[random.below(std::size(kOften))]];
  if (blocks.empty()) return;
  const std::size_t index = random.below(blocks.size());
  std::vector<std::byte>& bytes = blocks[index].bytes;
  switch (random.below(8)) {
    case 0:
      blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(index));
      return;
    case 1:
      blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(index), blocks[random.below(blocks.size())]);
      return;
    case 2:
      for (std::size_t at = random.below(bytes.size()); at < bytes.size(); ++at)
        bytes[at] = static_cast<std::byte>(random.bits());
      return;
    default:
      break;
  }
  const std::uint64_t odd = oddNumber(random);
  const std::size_t size = std::min<std::size_t>(bytes.size(), std::size_t{1} << random.below(4));
  std::memcpy(&bytes[random.below(bytes.size() / size) * size], &odd, size);
}

void changeAttribute(Random& random, Parts& parts) {
  record::Attribute& attribute = parts.attributes[random.below(parts.attributes.size())];
  switch (random.below(3)) {
    case 0:
      attribute.value = static_cast<std::int64_t>(oddNumber(random));
      break;
    case 1: {
      const std::uint64_t bits = oddNumber(random);
      double real = 0.0;
      std::memcpy(&real, &bits, sizeof real);
      attribute.value = real;
      break;
    }
    default:
      attribute.value = std::string(random.below(2) == 0 ? random.below(50'000) : random.below(4), '%');
  }
}

void changeLayout(Random& random, Parts& parts) {
  Table& table = parts.tables[random.below(record::kTables)];
  constexpr std::int64_t kRows[] = {1, 2, 7, 63, 64, 100, 4096, 200'000};
  (random.below(2) == 0 ? table.block_rows : table.chunk_rows) = kRows[random.below(std::size(kRows))];
}

/// As a careless disk, or a careful enemy, would have it.
void writeMutated(Random& random, const std::string& bytes, Parts parts, const std::string& path) {
  if (random.below(3) == 0) {
    std::string changed = bytes;
    for (std::size_t change = 1 + random.below(4); change > 0; --change) {
      const std::size_t at =
          random.below(random.below(2) == 0 ? changed.size() : std::min<std::size_t>(changed.size(), 20'000));
      const std::uint64_t odd = oddNumber(random);
      if (random.below(2) == 0) {
        changed[at] = static_cast<char>(odd);
      } else {
        std::memcpy(&changed[at], &odd, std::min<std::size_t>(sizeof odd, changed.size() - at));
      }
    }
    if (random.below(8) == 0) changed.resize(random.below(changed.size()));
    writeAt(path, changed);
    return;
  }
  for (std::size_t change = 1 + random.below(3); change > 0; --change) {
    const std::size_t kind = random.below(10);
    kind < 8 ? changeBlocks(random, parts) : kind < 9 ? changeAttribute(random, parts) : changeLayout(random, parts);
  }
  writeParts(path, parts);
}

struct Counted {
  int refused = 0, read = 0, replayed = 0, recovered = 0;
};

void expectWords(const Problems& problems) {
  for (const Problem& problem : problems) EXPECT_GT(problem.sentence.size(), 10U);
}

/// Read in every way that the programs have; what comes of it may be nonsense.
void look(const std::string& path, const ScratchFolder& folder, Random& random, Counted& counted) {
  Result<Session> opened = Session::open(path);
  ++(opened ? counted.read : counted.refused);
  if (!opened) return expectWords(opened.problems());
  Session& session = opened.value();
  expectWords(session.info().damage);
  for (const record::ChangeRow& change : session.changes()) (void)session.sceneText(change);
  expectWords(session.eachBlock([](const Block&, std::int64_t) { return true; }, [](const record::Gap&) {}));
  switch (random.below(4)) {
    case 0: {
      const Result<record::Verified> verified = record::verifyReplay(session, {}, {UNDERACT_SOURCE "/scenes"});
      if (!verified) expectWords(verified.problems());
      counted.replayed += verified && !verified.value().differs && verified.value().unknown.empty() ? 1 : 0;
      break;
    }
    case 1: {
      const auto recorded = device::loadRecorded(session, {});
      if (!recorded) expectWords(recorded.problems());
      break;
    }
    case 2: {
      Result<record::CsvWriter> csv = record::CsvWriter::create(folder.file("out.csv"), system::Existing::ReplaceFile);
      if (csv) expectWords(record::exportCsv(session, csv.value(), [](double) { return true; }).unread);
      break;
    }
    default:
      session.refresh();
      (void)session.start(programOf(sphereScene()));
  }
}

std::int64_t peak_MiB(int whose) {
  rusage usage{};
  ::getrusage(whose, &usage);
  return usage.ru_maxrss / 1024;
}

}  // namespace

TEST(SessionMutation, OfAnyKindIsASentenceOrReadAndNothingElseIsTouched) {
  const ScratchFolder folder;
  std::vector<std::string> seeds;
  for (const char* scene :
       {"02_sphere", "25_torus_knot", "28_trefoil_path", "18_sphere_of_two_joints", "12_line_pid"}) {
    seeds.push_back(folder.file(std::string(scene) + ".h5"));
    recordEvents(seeds.back(), sceneAt(std::string(UNDERACT_SOURCE) + "/scenes/" + scene + ".json"), "probe", Seed{26});
    ASSERT_FALSE(::testing::Test::HasFatalFailure());
  }
  std::vector<std::string> wholes;
  std::vector<Parts> parts;
  for (const std::string& seed : seeds) {
    wholes.push_back(bytesAt(seed));
    parts.push_back(partsOf(seed));
  }
  const std::string beside = folder.write("beside.txt", "of no session");
  Random random(Seed{20070601});
  Counted counted;
  double longest_s = 0.0;
  const int files = dearSweep(250, 100'000);
  for (int number = 0; number < files && !::testing::Test::HasFailure(); ++number) {
    SCOPED_TRACE(number);
    const std::size_t seed = random.below(seeds.size());
    const std::string path = folder.file("m.h5");
    writeMutated(random, wholes[seed], parts[seed], path);
    const auto start = std::chrono::steady_clock::now();
    look(path, folder, random, counted);
    if (number % 4 == 0) {
      const std::string before = bytesAt(path);
      const Result<std::int64_t> recovered = record::recover(path);
      if (!recovered) {
        expectWords(recovered.problems());
        EXPECT_EQ(bytesAt(path), before) << "what cannot be recovered stays as it is";
      }
      EXPECT_FALSE(std::filesystem::exists(path + ".part"));
      counted.recovered += recovered ? 1 : 0;
    }
    longest_s = std::max(longest_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    EXPECT_LT(longest_s, kLongest_s);
    if (isSoak() && (number + 1) % 1000 == 0) {  // hours of it: how far it is
      std::printf("%d files\n", number + 1);
      std::fflush(stdout);
    }
  }
  for (std::size_t seed = 0; seed < seeds.size(); ++seed) EXPECT_EQ(bytesAt(seeds[seed]), wholes[seed]);
  EXPECT_EQ(bytesAt(beside), "of no session");
  std::printf(
      "%d files: %d refused, %d read, %d of these replayed to the bit, %d recovered; at most %.2f s, %ld MiB here, %ld "
      "MiB in the reader\n",
      files, counted.refused, counted.read, counted.replayed, counted.recovered, longest_s,
      static_cast<long>(peak_MiB(RUSAGE_SELF)), static_cast<long>(peak_MiB(RUSAGE_CHILDREN)));
  EXPECT_GT(counted.refused, 0);
  EXPECT_GT(counted.read, 0);
  if (!kIsWatched) {
    EXPECT_LT(peak_MiB(RUSAGE_SELF), 600);
    EXPECT_LT(peak_MiB(RUSAGE_CHILDREN), 400);
  }
}

}  // namespace underact::test
