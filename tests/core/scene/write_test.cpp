#include "core/scene/write.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "core/scene/compile.h"
#include "tests/core/scene/random_scene.h"

namespace underact::scene {
namespace {

/// Empty, or what differs.
std::string roundTripOf(const Description& scene) {
  const std::string text = writeScene(scene);
  const Result<Description> read = readScene(text, "written.json");
  if (!read) return text + test::joined(test::linesOf(read.problems()));
  if (!test::same(read.value(), scene)) return text + "reads back to another scene.";
  return writeScene(read.value()) == text ? "" : text + "is written differently the second time.";
}

Description onePoint() {
  Description scene;
  scene.title = "t";
  scene.constraints.push_back({"point 1", Point{Vec3::Zero()}, target::Side::Both, {}, {}});
  return scene;
}

TEST(WriteScene, KeysAtTheirDefaultsAreLeftOut) {
  EXPECT_EQ(writeScene(onePoint()),
            "{\n  \"underact_scene\": 1,\n  \"title\": \"t\",\n  \"constraints\": [\n"
            "    {\"type\": \"point\", \"position_mm\": [0, 0, 0]}\n  ]\n}\n");
}

TEST(WriteScene, EverythingElseIsWrittenOnceAndShort) {
  Description scene = onePoint();
  scene.about = "What to feel.";
  scene.arm = "touch-measured";
  scene.combine = tick::Combine::Nearest;
  scene.simulation = {Integrator::EndVelocity, 100.0};
  scene.control.law = LawType::PD;
  scene.control.gains.kp_N_per_mm = Vec3(0.5, 0.25, 0.1);
  scene.control.gains.kd_N_s_per_mm = Vec3::Constant(0.002);
  scene.constraints[0].name = "here";
  Constraint box{"box 2", Box{Vec3(1, 2, 3), Vec3(4, 5, 6)}, target::Side::Inside, Control{}, {}};
  std::get<Box>(box.shape).R_WB << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  box.control->anisotropy = Anisotropy::Euclidean;
  scene.constraints.push_back(box);
  EXPECT_EQ(writeScene(scene), R"({
  "underact_scene": 1,
  "title": "t",
  "about": "What to feel.",
  "arm": "touch-measured",
  "control": {"law": "PD", "kp_N_per_mm": [0.5, 0.25, 0.1], "kd_N_s_per_mm": 0.002},
  "combine": "nearest",
  "simulation": {"integrator": "end_velocity", "substep_us": 100},
  "constraints": [
    {"name": "here", "type": "point", "position_mm": [0, 0, 0]},
    {
      "type": "box",
      "center_mm": [1, 2, 3],
      "size_mm": [4, 5, 6],
      "R_WB": [[0, -1, 0], [1, 0, 0], [0, 0, 1]],
      "side": "inside",
      "control": {"law": "P", "anisotropy": "euclidean"}
    }
  ]
}
)");
  EXPECT_EQ(roundTripOf(scene), "");
}

TEST(WriteScene, RandomScenesReadBackToTheLastBitAndCompile) {
  test::RandomScene scenes(test::Seed{20070601});
  for (int i = 0; i < test::sweep(2000, 200000); ++i) {
    const Description scene = scenes.next();
    ASSERT_EQ(test::joined(test::linesOf(check(scene))), "") << writeScene(scene);
    ASSERT_EQ(roundTripOf(scene), "");
    const Result<tick::TickProgram> program = compile(scene);
    ASSERT_TRUE(program) << writeScene(scene) << test::joined(test::linesOf(program.problems()));
    ASSERT_EQ(program.value().entries.size(), scene.constraints.size());
  }
}

TEST(WriteScene, EverySceneThatShipsReadsBack) {
  for (const std::filesystem::path& file : test::sceneFiles()) {
    EXPECT_EQ(roundTripOf(readSceneFile(file.string()).value()), "") << file;
  }
}

class WriteSceneFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = ::testing::TempDir() + "/scene_XXXXXX";
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::size_t filesThere() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }
  std::filesystem::path folder_;
};

TEST_F(WriteSceneFile, ReplacesTheFileKeepsItsRightsAndLeavesNothingElse) {
  const std::filesystem::path path = folder_ / "a.json";
  std::ofstream(path) << "old";
  ::chmod(path.c_str(), 0640);
  EXPECT_TRUE(writeSceneFile(onePoint(), path.string()).empty());
  EXPECT_EQ(test::fileText(path), writeScene(onePoint()));
  struct stat status {};
  ::stat(path.c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_EQ(filesThere(), 1u);
  const Result<Description> read = readSceneFile(path.string());
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value().file, path.string());
}

TEST_F(WriteSceneFile, ALinkStaysALink) {
  std::ofstream(folder_ / "real.json") << "old";
  std::filesystem::create_symlink("real.json", folder_ / "link.json");
  EXPECT_TRUE(writeSceneFile(onePoint(), (folder_ / "link.json").string()).empty());
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.json"));
  EXPECT_EQ(test::fileText(folder_ / "real.json"), writeScene(onePoint()));
}

TEST_F(WriteSceneFile, SaysWhyItCannotSaveAndLeavesNothingHalf) {
  const std::string nowhere = (folder_ / "no" / "a.json").string();
  const Problems missing = writeSceneFile(onePoint(), nowhere);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(describe(missing[0]), nowhere + ": error: The scene cannot be saved: No such file or directory.");
  const Problems folder = writeSceneFile(onePoint(), folder_.string());
  ASSERT_EQ(folder.size(), 1u);
  EXPECT_EQ(folder[0].sentence, "This is a folder; a scene needs a file name.");
  EXPECT_EQ(filesThere(), 0u);
}

/// Ends the process: 0 where saving was refused. A limit of the size of files stands in for the full disk.
[[noreturn]] void saveOnFullDisk(const std::string& path) {
  rlimit limit{};
  limit.rlim_cur = 10;
  limit.rlim_max = 10;
  std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::_exit(writeSceneFile(onePoint(), path).size() == 1 ? 0 : 1);
}

TEST_F(WriteSceneFile, AFullDiskLosesNothing) {
  const std::filesystem::path path = folder_ / "a.json";
  std::ofstream(path) << "old";
  EXPECT_EXIT(saveOnFullDisk(path.string()), ::testing::ExitedWithCode(0), "");
  EXPECT_EQ(test::fileText(path), "old");
  EXPECT_EQ(filesThere(), 1u);
}

}  // namespace
}  // namespace underact::scene
