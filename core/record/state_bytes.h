#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/tick/state.h"

namespace underact::record {

/// The servo's state as bytes: the start of a replay. For the build that wrote it and others whose state has the same
/// layout (stateLayout()); all builds of a version do, at any optimization.
std::vector<std::byte> bytesOfState(const tick::TickState& state);

/// "1:..." with the sizes of all parts: equal layouts can read each other's bytes.
std::string stateLayout();

/// program: the one that the state belongs to. Problems: the bytes are not such a state, or one that no servo can be
/// in.
Result<tick::TickState> stateOfBytes(const std::vector<std::byte>& bytes, const tick::TickProgram& program);

}  // namespace underact::record
