#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/tick/state.h"

namespace underact::record {

/// The servo's state as bytes, from which a replay begins: readable by builds with the same layout (stateLayout()),
/// which all builds of a version have, whatever their optimisation.
std::vector<std::byte> bytesOfState(const tick::TickState& state);

/// "1:..." with the sizes of all parts: equal layouts can read each other's bytes.
std::string stateLayout();

/// The state of such bytes. program: for which the state was made. Problems: the bytes are not of such a state, or of
/// one that no servo can be in.
Result<tick::TickState> stateOfBytes(const std::vector<std::byte>& bytes, const tick::TickProgram& program);

}  // namespace underact::record
