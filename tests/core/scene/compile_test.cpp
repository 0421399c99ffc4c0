#include "core/scene/compile.h"

#include "core/base/units.h"
#include "core/tick/state.h"
#include "tests/core/scene/random_scene.h"

namespace underact::scene {
namespace {

tick::TickProgram programOf(const std::string& text) {
  const Result<Description> read = readScene(text, "f");
  EXPECT_TRUE(read) << test::joined(test::linesOf(read.problems()));
  return compile(read.value()).value();
}

tick::TickProgram programOf(const std::string& keys, const std::string& constraints) {
  return programOf("{\"underact_scene\": 1, \"title\": \"t\", " + keys + "\"constraints\": [" + constraints + "]}");
}

const target::NearestOnShape& nearestOf(const tick::Entry& entry) {
  return std::get<target::NearestOnShape>(entry.constraint.goal);
}

const std::string kPointAside = R"({"type": "point", "position_mm": [10, -20, 30]})";
const std::string kSphere = R"({"type": "sphere", "center_mm": [10, 20, 30], "radius_mm": 40})";

TEST(CompileScene, MillimetresBecomeMetresByOneMultiplication) {
  const tick::TickProgram program = programOf("", kSphere);
  const shape::Sphere& sphere = std::get<shape::Sphere>(nearestOf(program.entries[0]).shape);
  EXPECT_EQ(sphere.p_WC, Vec3(10 * 1e-3, 20 * 1e-3, 30 * 1e-3));
  EXPECT_EQ(sphere.radius_m, 40 * 1e-3);
}

TEST(CompileScene, EveryTypeBecomesItsOwnShape) {
  const tick::TickProgram program =
      programOf("", kPointAside + "," + kSphere +
                        R"(, {"type": "line", "point_mm": [1, 2, 3], "direction": [0, 0, 4]},
                   {"type": "plane", "point_mm": [1, 2, 3], "normal": [0, 4, 0], "side": "outside"},
                   {"type": "circle", "center_mm": [1, 2, 3], "normal": [4, 0, 0], "radius_mm": 5},
                   {"type": "cylinder", "point_mm": [1, 2, 3], "axis": [4, 0, 0], "radius_mm": 5, "side": "inside"},
                   {"type": "box", "center_mm": [1, 2, 3], "size_mm": [4, 5, 6], "R_WB": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]})");
  const Vec3 p_WC(1 * 1e-3, 2 * 1e-3, 3 * 1e-3);
  const auto shapeAt = [&](std::size_t index) -> const shape::Shape& {
    return nearestOf(program.entries[index]).shape;
  };
  EXPECT_EQ(std::get<shape::Point>(shapeAt(0)).p_WC, Vec3(10 * 1e-3, -20 * 1e-3, 30 * 1e-3));
  EXPECT_EQ(std::get<shape::Line>(shapeAt(2)).p_WC, p_WC);
  EXPECT_EQ(std::get<shape::Line>(shapeAt(2)).axis_W, Vec3::UnitZ());
  EXPECT_EQ(std::get<shape::Plane>(shapeAt(3)).normal_W, Vec3::UnitY());
  EXPECT_EQ(program.entries[3].constraint.side, target::Side::Outside);
  EXPECT_EQ(std::get<shape::Circle>(shapeAt(4)).axis_W, Vec3::UnitX());
  EXPECT_EQ(std::get<shape::Circle>(shapeAt(4)).radius_m, 5 * 1e-3);
  EXPECT_EQ(std::get<shape::Cylinder>(shapeAt(5)).axis_W, Vec3::UnitX());
  EXPECT_EQ(std::get<shape::Cylinder>(shapeAt(5)).radius_m, 5 * 1e-3);
  EXPECT_EQ(program.entries[5].constraint.side, target::Side::Inside);
  const shape::Box& box = std::get<shape::Box>(shapeAt(6));
  EXPECT_EQ(box.p_WC, p_WC);
  EXPECT_EQ(box.half_m, Vec3(4 * 1e-3 / 2, 5 * 1e-3 / 2, 6 * 1e-3 / 2));
  EXPECT_TRUE((box.R_WB * Vec3::UnitX()).isApprox(Vec3::UnitY()));
}

TEST(CompileScene, GainsBecomeSiAndTheIntegralIsHeldWithinTheArmsContinuousForce) {
  const tick::TickProgram program = programOf(
      R"("control": {"law": "PID", "kp_N_per_mm": [1, 2, 3], "kd_N_s_per_mm": 0.25, "ki_N_per_mm_s": [4, 5, 6]}, )",
      kPointAside);
  const control::PID& law = std::get<control::PID>(program.entries[0].law);
  EXPECT_EQ(law.kp_N_per_m, Vec3(1000, 2000, 3000));
  EXPECT_EQ(law.kd_N_s_per_m, Vec3::Constant(250));
  EXPECT_EQ(law.ki_N_per_m_s, Vec3(4000, 5000, 6000));
  EXPECT_EQ(law.integral_limit_N, 0.88);
  EXPECT_EQ(program.limits.max_force_N, 0.88);
  const tick::TickProgram default_value = programOf("", kPointAside);
  EXPECT_EQ(std::get<control::P>(default_value.entries[0].law).kp_N_per_m, Vec3::Constant(500));
  const tick::TickProgram damped = programOf(R"("control": {"law": "PD", "kd_N_s_per_mm": 0.002}, )", kPointAside);
  EXPECT_EQ(std::get<control::PD>(damped.entries[0].law).kd_N_s_per_m, Vec3::Constant(0.002 * 1e3));
  EXPECT_EQ(std::get<control::PD>(damped.entries[0].law).kp_N_per_m, Vec3::Constant(500));
}

TEST(CompileScene, TheArmIsTheOneThatTheSceneNames) {
  EXPECT_EQ(programOf("", kPointAside).geometry.upper_m, 0.127508);
  EXPECT_EQ(programOf(R"("arm": "touch-measured", )", kPointAside).geometry.upper_m, 0.13335);
}

TEST(CompileScene, OnlyWhatTheSceneNeedsIsNeeded) {
  const auto needs = [](const std::string& keys, const std::string& constraints) {
    const tick::Needs found = programOf(keys, constraints).needs;
    return std::string(found.rate ? "rate " : "") + (found.integral ? "integral " : "") +
           (found.metric ? "metric " : "") + (found.choice ? "choice " : "");
  };
  EXPECT_EQ(needs("", kPointAside), "");
  EXPECT_EQ(needs("", kSphere), "");
  EXPECT_EQ(needs(R"("control": {"law": "PD"}, )", kPointAside), "rate ");
  EXPECT_EQ(needs(R"("control": {"law": "PID"}, )", kPointAside), "rate integral ");
  EXPECT_EQ(needs(R"("control": {"kp_N_per_mm": [1, 2, 3]}, )", kSphere), "metric ");
  EXPECT_EQ(needs(R"("control": {"kp_N_per_mm": [2, 2, 2]}, )", kSphere), "");
  EXPECT_EQ(needs(R"("control": {"kp_N_per_mm": [1, 2, 3], "anisotropy": "euclidean"}, )", kSphere), "");
  EXPECT_EQ(needs(R"("control": {"kp_N_per_mm": [1, 2, 3]}, )", kPointAside),
            "");                                                   // a point is nearest in every metric
  EXPECT_EQ(needs(R"("combine": "nearest", )", kPointAside), "");  // nothing to choose from
  EXPECT_EQ(needs(R"("combine": "nearest", )", kPointAside + "," + kSphere), "choice ");
  EXPECT_EQ(needs(R"("control": {"law": "PID"}, )", R"({"type": "point", "position_mm": [0, 0, 0], "control": {}})"),
            "");
}

TEST(CompileScene, AVelocityFilterInMetresAndSeconds) {
  const auto velocityOf = [](const std::string& velocity) {
    const tick::TickProgram program =
        programOf(R"("control": {"law": "PD", "velocity": )" + velocity + "}, ", kPointAside);
    return std::get<control::PD>(program.entries[0].law).velocity;
  };
  const auto kalman = std::get<control::Kalman>(velocityOf(R"({"filter": "kalman"})"));
  EXPECT_EQ(kalman.noise, 0.016e-3);
  EXPECT_EQ(kalman.acceleration, 8.0);
  EXPECT_EQ(std::get<control::LowPass>(velocityOf(R"({"filter": "low_pass"})")).time_constant_s,
            control::kRateFilter_s);
  const auto adaptive = std::get<control::AdaptiveWindow>(velocityOf(R"({"filter": "adaptive_window"})"));
  EXPECT_EQ(adaptive.window, 8);
  EXPECT_EQ(adaptive.noise, Vec3(Vec3::Constant(0.11e-3)));
  EXPECT_TRUE(std::holds_alternative<control::RawDifference>(velocityOf(R"({"filter": "raw"})")));
  const tick::TickProgram pid = programOf(R"("control": {"law": "PID", "velocity": {"filter": "raw"}}, )", kPointAside);
  EXPECT_TRUE(std::holds_alternative<control::RawDifference>(std::get<control::PID>(pid.entries[0].law).velocity));
}

TEST(CompileScene, TheNoiseOfAJointIsThatOfTheTipAtItsLever) {
  const tick::TickProgram program = programOf(
      R"("control": {"law": "PD", "space": "joint", "velocity": {"filter": "adaptive_window"}}, )", kPointAside);
  const Vec3 noise_rad =
      std::get<control::AdaptiveWindow>(std::get<control::PD>(program.entries[0].law).velocity).noise;
  // Levers of 0.18 m about the base, 0.13 and 0.15 m about shoulder and elbow or so: 0.11 mm is 0.6 to 0.9 mrad.
  EXPECT_GT(noise_rad.minCoeff(), 0.5e-3);
  EXPECT_LT(noise_rad.maxCoeff(), 1e-3);
}

TEST(CompileScene, ALawWithoutMemoryCostsNoState) {
  const tick::TickState none = makeState(programOf(R"("control": {"passivity": "off"}, )", kPointAside));
  const tick::TickState one = makeState(programOf(R"("control": {"law": "PD", "passivity": "off"}, )", kPointAside));
  EXPECT_EQ(tick::bytesOf(none), sizeof(tick::TickState));
  EXPECT_EQ(tick::bytesOf(one), sizeof(tick::TickState) + sizeof(control::LawState));
}

TEST(CompileScene, EnergyIsWatchedUnlessTheSceneSaysOff) {
  EXPECT_EQ(programOf("", kPointAside).entries[0].passivity, control::Passivity::Observe);
  EXPECT_TRUE(programOf("", kPointAside).needs.energy);
  const tick::TickState watched = makeState(programOf("", kPointAside));
  EXPECT_EQ(tick::bytesOf(watched), sizeof(tick::TickState) + sizeof(control::EnergyState));
  EXPECT_FALSE(programOf(R"("control": {"passivity": "off"}, )", kPointAside).needs.energy);
  EXPECT_EQ(programOf(R"("control": {"passivity": "control"}, )", kPointAside).entries[0].passivity,
            control::Passivity::Control);
}

TEST(CompileScene, UnequalGainsMakeTheirOwnMetricUnlessTheSceneSaysEuclidean) {
  const tick::TickProgram weighted = programOf(R"("control": {"kp_N_per_mm": [1, 4, 0.25]}, )", kSphere);
  EXPECT_TRUE(nearestOf(weighted.entries[0]).weighted);
  EXPECT_EQ(nearestOf(weighted.entries[0]).scale, Vec3(0.5, 1.0, 0.25));
  const tick::TickProgram euclidean =
      programOf(R"("control": {"kp_N_per_mm": [1, 4, 0.25], "anisotropy": "euclidean"}, )", kSphere);
  EXPECT_FALSE(nearestOf(euclidean.entries[0]).weighted);
  EXPECT_EQ(control::stiffness(euclidean.entries[0].law), Vec3(1000, 4000, 250));
}

TEST(CompileScene, AConstraintsOwnControlHoldsForItAlone) {
  const tick::TickProgram program =
      programOf(R"("control": {"law": "PD", "kp_N_per_mm": 2, "kd_N_s_per_mm": 1}, )",
                kPointAside + R"(, {"type": "point", "position_mm": [0, 0, 0], "control": {"kp_N_per_mm": 0.1}})");
  EXPECT_TRUE(std::holds_alternative<control::PD>(program.entries[0].law));
  EXPECT_EQ(std::get<control::P>(program.entries[1].law).kp_N_per_m, Vec3::Constant(100));
}

}  // namespace
}  // namespace underact::scene
