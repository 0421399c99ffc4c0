#include "core/record/state_bytes.h"

#include <cstring>
#include <type_traits>

#include "core/base/translate.h"

namespace underact::record {
namespace {

/// Every part of a state, in one place for both ways. What carryOver() hands on between two ticks is all in here.
template <class State, class Part>
void eachPart(State& state, Part&& part) {
  part(state.time_ns);
  part(state.has_time);
  part(state.p_WT);
  part(state.q_rad);
  part(state.limited);
  part(state.asked_T_W);
  part(state.bump_T_W);
  part(state.retuned);
  part(state.gate);
  for (auto& law : state.laws) part(law);
  for (auto& influence : state.influences) part(influence);
  for (auto& robot : state.robots) part(robot);
  for (auto& mesh : state.meshes) part(mesh);
  for (auto& curve : state.curves) part(curve);
  for (auto& grip : state.grips) part(grip);
  for (auto& energy : state.energies) part(energy);
  for (auto& follower : state.followers) part(follower);
}

/// Eigen's fixed sizes have no pointers in them, though the standard does not call them trivial.
template <class T>
constexpr bool kIsPlain = std::is_trivially_destructible_v<T>&& std::is_standard_layout_v<T>;

}  // namespace

std::vector<std::byte> bytesOfState(const tick::TickState& state) {
  std::vector<std::byte> bytes;
  eachPart(state, [&bytes](const auto& part) {
    static_assert(kIsPlain<std::remove_cvref_t<decltype(part)>>);
    const auto* const begin = reinterpret_cast<const std::byte*>(&part);
    bytes.insert(bytes.end(), begin, begin + sizeof part);
  });
  return bytes;
}

std::string stateLayout() {
  std::string layout = "1";
  for (const std::size_t size :
       {sizeof(tick::TickState), sizeof(safety::GateState), sizeof(control::LawState), sizeof(target::InfluenceState),
        sizeof(manipulator::State), sizeof(target::MeshState), sizeof(target::CurveState), sizeof(target::Grip),
        sizeof(control::EnergyState), sizeof(arm::FollowerState)}) {
    layout += ":" + std::to_string(size);
  }
  return layout;
}

Result<tick::TickState> stateOfBytes(const std::vector<std::byte>& bytes, const tick::TickProgram& program) {
  tick::TickState state = tick::makeState(program);
  std::size_t wanted = 0;
  eachPart(state, [&wanted](const auto& part) { wanted += sizeof part; });
  if (wanted != bytes.size())
    return Problems{{said(TRANSLATE_NOOP("problem", "The servo's memory at the beginning was not recorded whole."))}};
  const std::byte* next = bytes.data();
  eachPart(state, [&next](auto& part) {
    std::memcpy(static_cast<void*>(&part), next, sizeof part);
    next += sizeof part;
  });
  // A changed byte may say anything, and its checksum may have been put right.
  if (!isSound(state, program))
    return Problems{{said(TRANSLATE_NOOP("problem",
                                         "The servo's memory at the beginning of this session is none that a servo "
                                         "can have: the file is damaged, or was changed."))}};
  return state;
}

}  // namespace underact::record
