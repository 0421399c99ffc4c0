#include <gtest/gtest.h>

#include "core/record/provenance.h"
#include "core/record/replay.h"
#include "core/scene/edit.h"
#include "device/rerun_session.h"
#include "tests/serve/desk.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

Vec3 anyVector(Random& random, double max) {
  return {random.between(-max, max), random.between(-max, max), random.between(-max, max)};
}

/// A ball, a wall, a box and a pointed-at ring: targets that are carried in all their numbers.
scene::Description carriedScene() {
  scene::Description scene = sphereScene();
  scene.control.law = scene::LawType::PD;
  scene.control.gains.kd_N_s_per_mm.setConstant(0.001);
  scene.constraints.push_back({"wall", scene::Plane{Vec3(0.0, -20.0, 0.0), Vec3::UnitY()}, target::Side::Outside, {}});
  scene.constraints.push_back(
      {"box", scene::Box{Vec3(30.0, 0.0, 0.0), Vec3(20.0, 30.0, 40.0)}, target::Side::Both, {}});
  scene::Constraint ring{"ring", scene::Circle{Vec3::Zero(), Vec3::UnitZ(), 40.0}, target::Side::Both, {}};
  ring.influence = scene::Influence{};
  scene.constraints.push_back(ring);
  return scene;
}

scene::Description withTargetsMoved(scene::Description scene, Random& random) {
  for (scene::Constraint& constraint : scene.constraints) {
    if (random.below(2) == 0) continue;
    if (auto* sphere = std::get_if<scene::Sphere>(&constraint.shape)) {
      sphere->center_mm += anyVector(random, 5.0);
      sphere->radius_mm = random.between(20.0, 60.0);
    }
    if (auto* plane = std::get_if<scene::Plane>(&constraint.shape))
      plane->normal = Vec3(0.0, 1.0, 0.0) + anyVector(random, 0.5);
    if (auto* box = std::get_if<scene::Box>(&constraint.shape)) {
      box->center_mm += anyVector(random, 5.0);
      box->R_WB = Eigen::AngleAxisd(random.between(-1.0, 1.0), Vec3::UnitX()).toRotationMatrix();
    }
    if (auto* ring = std::get_if<scene::Circle>(&constraint.shape)) ring->center_mm += anyVector(random, 5.0);
  }
  return scene;
}

/// A session in which a program moves targets, adds forces, edits, starts and stops, and which begins in the midst.
void recordSteered(const std::string& path, Seed seed) {
  Random random(seed);
  const std::unique_ptr<servo::Host> host = makeHost(servo::Clock::Manual, "tremor", 1000, seed.value);
  ASSERT_TRUE(host->load(carriedScene()).empty());
  host->start();
  host->run(300);
  ASSERT_TRUE(host->edit(withTargetsMoved(host->scene(), random), 40).empty());
  host->push(Vec3(0.3, 0.0, -0.2), 30);
  host->run(static_cast<std::int64_t>(random.below(50)));
  const auto recorder = record::Recorder::start(*host, path, {.name = "steered"});
  ASSERT_TRUE(recorder);
  for (int event = 0; event < 40; ++event) {
    host->run(1 + static_cast<std::int64_t>(random.below(30)));
    switch (random.below(6)) {
      case 0:
        host->push(anyVector(random, 1.0), static_cast<std::int64_t>(random.below(60)));
        break;
      case 1:
        host->stop();
        host->run(static_cast<std::int64_t>(random.below(80)));
        host->start();
        break;
      case 2: {
        scene::Description tuned = host->scene();
        tuned.control.gains.kp_N_per_mm.setConstant(random.between(0.1, 0.6));
        ASSERT_TRUE(host->edit(tuned).empty());
        break;
      }
      default:
        ASSERT_TRUE(
            host->edit(withTargetsMoved(host->scene(), random), static_cast<std::int64_t>(random.below(25))).empty());
    }
  }
  host->run(60);
  const Problems problems = recorder.value()->stop();
  EXPECT_TRUE(problems.empty());
}

void expectSame(const std::string& path, std::uint64_t seed) {
  Result<record::Session> session = record::Session::open(path);
  ASSERT_TRUE(session) << session.problems().front().sentence;
  const Result<record::Verified> verified = record::verifyReplay(session.value());
  ASSERT_TRUE(verified) << verified.problems().front().sentence;
  EXPECT_EQ(verified.value().ticks, session.value().info().ticks) << "seed " << seed;
  EXPECT_FALSE(verified.value().differs) << "seed " << seed << ", tick " << verified.value().differs->tick << ", "
                                         << verified.value().differs->column;
  EXPECT_EQ(verified.value().unknown, "");
}

TEST(SteeredSession, ReplaysToTheBitWithCarriedTargetsAndAddedForces) {
  const ScratchFolder folder;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(sweep(12, 200)); ++seed) {
    const std::string path = folder.path() + "/" + std::to_string(seed) + ".h5";
    recordSteered(path, Seed{seed});
    expectSame(path, seed);
  }
}

TEST(SteeredSession, IsMadeAgainFromItsFileAloneAndTheNewFileSaysTheSame) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/first.h5", again = folder.path() + "/again.h5";
  recordSteered(path, Seed{77});
  Result<record::Session> session = record::Session::open(path);
  ASSERT_TRUE(session);
  device::RerunOptions options;
  options.out.path = again;
  const Result<device::RerunResult> rerun = device::rerun(session.value(), options);
  ASSERT_TRUE(rerun) << rerun.problems().front().sentence;
  EXPECT_FALSE(rerun.value().verified.differs);
  expectSame(again, 77);
  Result<record::Session> made = record::Session::open(again);
  ASSERT_TRUE(made);
  EXPECT_EQ(made.value().pushes().size(), session.value().pushes().size());
}

/// A session that clients steer at random, each of whom is gone in the midst of it.
void recordClients(const std::string& file, std::uint64_t seed, std::string& path) {
  Random random{Seed{seed}};
  Desk desk(false, "tremor", seed);
  desk.run(static_cast<int>(random.below(20)));
  int client = desk.join("first");
  ASSERT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 1, "do": "record", "file": ")" + file + "\"}")));
  path = desk.folder.path() + "/sessions/" + file;
  desk.ask(client, R"({"id": 1, "do": "constraint.add", "constraint": {"name": "wall", "type": "plane",
                     "point_mm": [0, 0, 0], "normal": [0, 1, 0], "side": "outside"}})");
  desk.ask(client, R"({"id": 1, "do": "start"})");
  const auto number = [&random](double max) { return json::numberText(random.between(-max, max)); };
  for (int act = 0; act < 40; ++act) {
    desk.run(static_cast<int>(random.below(30)));
    switch (random.below(8)) {
      case 0:
        desk.send(client, R"({"id": 1, "do": "force", "f_N": [)" + number(1) + ", " + number(1) + ", " + number(1) +
                              R"(], "for_ms": )" + std::to_string(1 + random.below(200)) + "}");
        break;
      case 1:
        desk.send(client, R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": )" +
                              json::numberText(random.between(0.0, 0.8)) + "}}");
        break;
      case 2:
        desk.send(client, random.below(2) == 0 ? R"({"id": 1, "do": "stop"})" : R"({"id": 1, "do": "start"})");
        break;
      case 3:
        desk.service->disconnect(client);  // killed
        client = desk.join("next");
        break;
      case 4:
        desk.send(client, R"({"id": 1, "do": "mark", "text": "act"})");
        break;
      default:
        desk.send(client, R"({"id": 1, "do": "constraint.move", "name": "wall", "values": {"point_mm": [0, )" +
                              number(15) + R"(, 0]}, "over_ms": )" + std::to_string(random.below(30)) + "}");
    }
    desk.take(client);
  }
  desk.run(100);
  desk.service->disconnect(client);
  desk.run(20);
  EXPECT_TRUE(desk.alone->close().empty());
  std::filesystem::rename(path, std::filesystem::temp_directory_path() / file);
  path = (std::filesystem::temp_directory_path() / file).string();
}

TEST(SteeredSession, OfClientsWhoAreGoneReplaysAndIsMadeAgainToTheBit) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(sweep(12, 200)); ++seed) {
    std::string path;
    recordClients("steered_" + std::to_string(seed) + "_" + record::newSessionId() + ".h5", seed, path);
    if (HasFatalFailure()) return;
    expectSame(path, seed);
    Result<record::Session> session = record::Session::open(path);
    ASSERT_TRUE(session);
    const Result<device::RerunResult> rerun = device::rerun(session.value());
    ASSERT_TRUE(rerun) << rerun.problems().front().sentence;
    EXPECT_FALSE(rerun.value().verified.differs) << "seed " << seed;
    EXPECT_EQ(rerun.value().verified.ticks, session.value().info().ticks);
    std::filesystem::remove(path);
  }
}

TEST(CarriedTarget, MovesInEqualStepsAndStandsExactlyWhereItWasSent) {
  const std::unique_ptr<servo::Host> host = makeHost(servo::Clock::Manual, "still");
  scene::Description scene = sphereScene();
  scene.constraints = {{"post", scene::Point{Vec3::Zero()}, target::Side::Both, {}}};
  ASSERT_TRUE(host->load(scene).empty());
  host->start();
  host->run(200);
  host->drain([](const servo::TickRecord&) {});
  std::get<scene::Point>(scene.constraints[0].shape).position_mm = Vec3(10.0, 0.0, -4.0);
  ASSERT_TRUE(host->edit(scene, 10).empty());
  host->run(12);
  std::vector<double> x_mm;
  host->drain([&x_mm](const servo::TickRecord& record) { x_mm.push_back(1e3 * record.p_WP.x()); });
  ASSERT_EQ(x_mm.size(), 12U);
  for (std::size_t tick = 0; tick < 10; ++tick) EXPECT_NEAR(x_mm[tick], 1.0 + static_cast<double>(tick), 1e-9);
  EXPECT_EQ(x_mm[9], 1e3 * 0.01);
  EXPECT_EQ(x_mm[11], 1e3 * 0.01);
}

TEST(CarriedTarget, GoesOnFromWhereItIsAndOverAChangeOfGains) {
  const std::unique_ptr<servo::Host> host = makeHost(servo::Clock::Manual, "still");
  scene::Description scene = sphereScene();
  scene.constraints = {{"post", scene::Point{Vec3::Zero()}, target::Side::Both, {}}};
  ASSERT_TRUE(host->load(scene).empty());
  host->start();
  host->run(200);
  auto& position_mm = std::get<scene::Point>(scene.constraints[0].shape).position_mm;
  position_mm = Vec3(10.0, 0.0, 0.0);
  ASSERT_TRUE(host->edit(scene, 10).empty());
  host->run(5);
  scene.control.gains.kp_N_per_mm.setConstant(0.3);
  ASSERT_TRUE(host->edit(scene).empty());
  host->run(1);
  EXPECT_NEAR(1e3 * host->snapshot().report.held[0].p_WP.x(), 6.0, 1e-9);
  position_mm = Vec3(-4.0, 0.0, 0.0);
  ASSERT_TRUE(host->edit(scene, 10).empty());
  host->run(1);
  EXPECT_NEAR(1e3 * host->snapshot().report.held[0].p_WP.x(), 5.0, 1e-9);
  host->run(9);
  EXPECT_EQ(host->snapshot().report.held[0].p_WP.x(), 1e-3 * -4.0);
}

TEST(AddedForce, IsInTheForceAskedForItsTicksAndNoLonger) {
  const std::unique_ptr<servo::Host> host = makeHost(servo::Clock::Manual, "still");
  scene::Description scene = sphereScene();
  scene.constraints = {{"post", scene::Point{Vec3::Zero()}, target::Side::Both, {}}};
  scene.control.gains.kp_N_per_mm.setZero();
  ASSERT_TRUE(host->load(scene).empty());
  host->start();
  host->run(200);
  host->drain([](const servo::TickRecord&) {});
  host->push(Vec3(0.5, 0.0, -0.25), 3);
  host->run(5);
  std::vector<Vec3> asked;
  host->drain([&asked](const servo::TickRecord& record) { asked.push_back(record.f_asked_T_W); });
  for (std::size_t tick = 0; tick < 3; ++tick) EXPECT_EQ(asked[tick], Vec3(0.5, 0.0, -0.25)) << tick;
  EXPECT_EQ(asked[3], Vec3(Vec3::Zero()));
  EXPECT_EQ(asked[4], Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace underact::test
