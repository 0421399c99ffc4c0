#include "core/record/state_bytes.h"

#include <array>
#include <cstring>
#include <type_traits>

#include "core/base/translate.h"

namespace underact::record {
namespace {

/// Behind a follower, as a compiler once left it there.
using FollowerEnd = std::array<std::byte, 4>;
constexpr std::size_t kFollowerBytes = 6 * sizeof(double) + sizeof(arm::Branch) + sizeof(bool) + sizeof(FollowerEnd);

/// The state of each target of a kind. An entry of another kind has none; its bytes are those of a state before a first
/// tick.
template <class Memory, class Entries, class Part>
void eachMemory(Entries& entries, Part&& part) {
  for (auto& entry : entries) {
    Memory none = Memory();
    auto* const memory = std::get_if<Memory>(&entry.target.memory);
    memory != nullptr ? part(*memory) : part(none);
  }
}

/// The gate with the heat of three motors; that of more is behind all other parts.
template <class Gate, class Part>
void eachPartOfGate(Gate& gate, Part&& part) {
  part(gate.level);
  part(gate.missed);
  part(gate.late);
  part(gate.still_s);
  part(gate.v_WT);
  part(gate.f_T_W);
  for (std::size_t motor = 0; motor < 3; ++motor) part(gate.heat[motor]);
  part(gate.letting_go);
  part(gate.fault);
}
constexpr std::size_t kGateBytes = 144;
constexpr std::size_t kFirstJoints = 6;  // those beyond are behind all other parts

/// A follower, which arms of six joints have.
template <class Follower, class Part>
void eachPartOf(Follower& follower, Part&& part) {
  for (std::size_t joint = 0; joint < kFirstJoints; ++joint) part(follower.q_rad[joint]);
  part(follower.branch);
  part(follower.begun);
  FollowerEnd end{};
  part(end);
}

/// All parts of a state, in one place for both directions: everything that carryOver() copies is among them.
template <class State, class Part>
void eachPart(State& state, Part&& part) {
  part(state.time_ns);
  part(state.has_time);
  part(state.p_WT);
  for (std::size_t joint = 0; joint < kFirstJoints; ++joint) part(state.q_rad[joint]);
  part(state.limited);
  part(state.asked_T_W);
  part(state.bump_T_W);
  part(state.retuned);
  eachPartOfGate(state.gate, part);
  const auto each = [&state](bool is_needed, auto&& of_entry) {
    for (std::size_t index = 0; is_needed && index < state.entries.size(); ++index) of_entry(state.entries[index]);
  };
  each(state.needs.rate, [&](auto& entry) { part(entry.law); });
  if (state.needs.orientation) eachMemory<target::InfluenceState>(state.entries, part);
  if (state.needs.robots) eachMemory<manipulator::State>(state.entries, part);
  if (state.needs.meshes) eachMemory<target::MeshState>(state.entries, part);
  if (state.needs.curves) eachMemory<target::CurveState>(state.entries, part);
  each(state.needs.friction, [&](auto& entry) { part(entry.target.grip); });
  each(state.needs.energy, [&](auto& entry) { part(entry.energy); });
  each(state.needs.joints, [&](auto& entry) { eachPartOf(entry.follower, part); });
  if (state.needs.more_joints) {
    for (std::size_t joint = kFirstJoints; joint < state.q_rad.size(); ++joint) part(state.q_rad[joint]);
  }
  if (!state.needs.more_motors) return;
  for (std::size_t motor = 3; motor < state.gate.heat.size(); ++motor) part(state.gate.heat[motor]);
  part(state.gate.m_T_W);
}

/// The way of each target that is being carried, behind all other parts; only of a state that carries one, so that all
/// others have the layout that they always had.
template <class State, class Part>
void eachCarried(State& state, Part&& part) {
  for (auto& entry : state.entries) {
    part(entry.carried.done);
    part(entry.carried.total);
    part(entry.carried.from);
  }
}

/// Eigen's fixed-size types have no pointers, although the standard does not call them trivial.
template <class T>
constexpr bool kIsPlain = std::is_trivially_destructible_v<T>&& std::is_standard_layout_v<T>;

}  // namespace

std::vector<std::byte> bytesOfState(const tick::TickState& state) {
  std::vector<std::byte> bytes;
  const auto add = [&bytes](const auto& part) {
    static_assert(kIsPlain<std::remove_cvref_t<decltype(part)>>);
    const auto* const begin = reinterpret_cast<const std::byte*>(&part);
    bytes.insert(bytes.end(), begin, begin + sizeof part);
  };
  eachPart(state, add);
  if (state.carries) eachCarried(state, add);
  return bytes;
}

std::string stateLayout() {
  // Files state 488 for a state without entries, its size in memory in version 1 of the layout.
  std::size_t bytes = 488 - 275;
  const tick::TickState none;
  eachPart(none, [&bytes](const auto& part) { bytes += sizeof part; });
  std::string layout = "1";
  for (const std::size_t size : {bytes, kGateBytes, sizeof(control::LawState), sizeof(target::InfluenceState),
                                 sizeof(manipulator::State), sizeof(target::MeshState), sizeof(target::CurveState),
                                 sizeof(target::Grip), sizeof(control::EnergyState), kFollowerBytes}) {
    layout += ":" + std::to_string(size);
  }
  return layout;
}

Result<tick::TickState> stateOfBytes(const std::vector<std::byte>& bytes, const tick::TickProgram& program) {
  tick::TickState state = tick::makeState(program);
  std::size_t wanted = 0;
  const auto count = [&wanted](const auto& part) { wanted += sizeof part; };
  eachPart(state, count);
  const std::size_t without_carried = wanted;
  eachCarried(state, count);
  state.carries = bytes.size() == wanted && bytes.size() != without_carried;
  if (bytes.size() != wanted && bytes.size() != without_carried)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "The servo's state at the beginning was not recorded completely."))}};
  const std::byte* next = bytes.data();
  const auto take = [&next](auto& part) {
    std::memcpy(static_cast<void*>(&part), next, sizeof part);
    next += sizeof part;
  };
  eachPart(state, take);
  if (state.carries) eachCarried(state, take);
  // A modified byte may have any value, and a correct checksum.
  if (!isValid(state, program))
    return Problems{{phrase(TRANSLATE_NOOP(
        "problem",
        "The servo's state at the beginning of this session is not valid: the file is damaged, or was changed."))}};
  return state;
}

}  // namespace underact::record
