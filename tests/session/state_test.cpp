// The servo's memory at the beginning of a recording, as a stranger might have written it.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "core/record/state_bytes.h"
#include "core/tick/step.h"
#include "tests/session/rig.h"
#include "tests/support/property.h"

namespace underact::record {
namespace {

using tick::TickProgram;
using tick::TickState;

TickProgram programAt(const std::string& scene) {
  return test::programOf(test::sceneAt(std::string(UNDERACT_SOURCE) + "/scenes/" + scene + ".json"));
}

/// After so many ticks of a hand that moves.
TickState ticked(const TickProgram& program, TickState state, int ticks) {
  tick::TickReport report;
  const auto from_ns = static_cast<std::uint64_t>(state.time_ns);  // of a file: any number
  for (int tick = 1; tick <= ticks; ++tick) {
    tick::TickInput input;
    input.sample.time_ns = static_cast<std::int64_t>(from_ns + 1'000'000U * static_cast<unsigned>(tick));
    input.sample.q_rad = {0.001 * tick, 0.6, 0.3 + 0.0005 * tick, 0.1, 1.2, 0.2};
    input.has_sample = input.engage = true;
    tick::step(program, input, state, report);
  }
  return state;
}

bool isTaken(const TickProgram& program, const TickState& state) {
  const Result<TickState> read = stateOfBytes(bytesOfState(state), program);
  if (!read) {
    EXPECT_NE(read.problems().front().sentence.find("is not valid"), std::string::npos);
  }
  return static_cast<bool>(read);
}

target::MeshState& meshOf(TickState& state) {
  return std::get<target::MeshState>(state.entries[0].target.memory);
}
target::CurveState& curveOf(TickState& state) {
  return std::get<target::CurveState>(state.entries[0].target.memory);
}

/// What a file may hold where a bool, or one byte, stands.
template <class Flag>
void setByte(Flag& flag, unsigned char value) {
  static_assert(sizeof flag == 1);
  std::memcpy(&flag, &value, 1);
}

}  // namespace

TEST(StartState, OfAServoInTheMidstOfAnySceneIsTaken) {
  for (const std::string& path : test::shippedScenes()) {
    const TickProgram program = test::programOf(test::sceneAt(path));
    TickState state = tick::makeState(program);
    EXPECT_TRUE(isTaken(program, state)) << path;
    for (int times = 0; times < 4; ++times) {
      state = ticked(program, state, 100);
      EXPECT_TRUE(isTaken(program, state)) << path << " after " << 100 * (times + 1) << " ticks";
    }
  }
}

TEST(StartState, WhoseIndexesLeadOutOfMemoryIsRefused) {
  const TickProgram knot = programAt("25_torus_knot"), path = programAt("28_trefoil_path");
  const TickState of_knot = ticked(knot, tick::makeState(knot), 50), of_path = ticked(path, tick::makeState(path), 50);
  const auto faces = static_cast<std::int32_t>(
      std::get<target::MeshPlace>(knot.entries[0].constraint.goal).surface->triangles.faces.size());
  const std::int32_t pieces = pieceCount(*std::get<target::CurvePath>(path.entries[0].constraint.goal).curve);
  for (const std::int32_t wrong : {-2, INT32_MIN, INT32_MAX}) {
    TickState state = of_knot;
    meshOf(state).search.face = wrong;
    EXPECT_FALSE(isTaken(knot, state));
    state = of_knot;
    meshOf(state).touch.face = wrong;
    EXPECT_FALSE(isTaken(knot, state));
    state = of_path;
    curveOf(state).search.piece = wrong;
    EXPECT_FALSE(isTaken(path, state));
  }
  TickState state = of_knot;
  meshOf(state).touch.face = faces;
  EXPECT_FALSE(isTaken(knot, state));
  meshOf(state).touch.face = faces - 1;
  EXPECT_TRUE(isTaken(knot, state));
  state = of_path;
  curveOf(state).search.piece = pieces;
  EXPECT_FALSE(isTaken(path, state));
  curveOf(state).search.piece = pieces - 1;
  EXPECT_TRUE(isTaken(path, state));
}

TEST(StartState, WhoseCountsFlagsAndWordsAreNoneIsRefused) {
  const TickProgram pid = programAt("12_line_pid");
  const TickState well = ticked(pid, tick::makeState(pid), 50);
  ASSERT_TRUE(well.needs.rate);
  const std::vector<std::function<void(TickState&)>> wrongs{
      [](TickState& state) { state.entries[0].law.velocity.window.newest = control::kLongestWindow + 1; },
      [](TickState& state) { state.entries[0].law.velocity.window.newest = -1; },
      [](TickState& state) { state.entries[0].law.velocity.window.count = control::kLongestWindow + 2; },
      [](TickState& state) { state.entries[0].law.velocity.window.count = INT32_MIN; },
      [](TickState& state) { state.entries[0].law.velocity.filter = 4; },
      [](TickState& state) { setByte(state.entries[0].law.velocity.has_last, 2); },
      [](TickState& state) { setByte(state.has_time, 255); },
      [](TickState& state) { setByte(state.limited, 2); },
      [](TickState& state) { setByte(state.retuned, 64); },
      [](TickState& state) { setByte(state.gate.fault.kind, kFaultKinds); },
      [](TickState& state) { setByte(state.gate.letting_go.kind, 255); },
      [](TickState& state) { state.gate.level = 1.5; },
      [](TickState& state) { state.gate.level = kNotANumber; },
      [](TickState& state) { state.gate.missed = INT32_MIN; },
      [](TickState& state) { state.gate.f_T_W.x() = kInfinity; },
      [](TickState& state) { state.gate.heat[2] = kNotANumber; },
      [](TickState& state) { state.p_WT.y() = kNotANumber; },
      [](TickState& state) { state.q_rad[5] = kInfinity; },
  };
  EXPECT_TRUE(isTaken(pid, well));
  for (std::size_t wrong = 0; wrong < wrongs.size(); ++wrong) {
    TickState state = well;
    wrongs[wrong](state);
    EXPECT_FALSE(isTaken(pid, state)) << wrong;
  }
}

// What is taken may be nonsense; a tick that begins from it stays in its memory, which the sanitizers watch.
TEST(StartState, OfAnyBytesIsRefusedOrTicks) {
  test::Random random(test::Seed{26});
  int taken = 0, refused = 0;
  for (const std::string& path : test::shippedScenes()) {
    const TickProgram program = test::programOf(test::sceneAt(path));
    const std::vector<std::byte> well = bytesOfState(ticked(program, tick::makeState(program), 20));
    for (int draw = test::dearSweep(60, 5'000); draw > 0; --draw) {
      std::vector<std::byte> bytes = well;
      for (std::size_t change = 1 + random.below(3); change > 0; --change) {
        const std::uint64_t any = random.bits();
        const std::int32_t wholes[] = {INT32_MAX, -1, INT32_MIN, 10'000'000, static_cast<std::int32_t>(any)};
        const std::int32_t whole = wholes[random.below(5)];
        if (random.below(2) == 0) {
          std::memcpy(&bytes[4 * random.below(bytes.size() / 4)], &whole, 4);
        } else {
          std::memcpy(&bytes[8 * random.below(bytes.size() / 8)], &any, 8);
        }
      }
      const Result<TickState> state = stateOfBytes(bytes, program);
      ++(state ? taken : refused);
      if (state) (void)ticked(program, state.value(), 5);
    }
  }
  std::printf("%d states taken, %d refused\n", taken, refused);
  EXPECT_GT(taken, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace underact::record
