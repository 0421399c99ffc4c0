#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/tick/state.h"

namespace underact::record {

/// The servo's memory as bytes: what a replay begins from. For the build that wrote it and for others whose memory is
/// laid out alike (stateLayout()); all builds of a version are, whatever they are optimised for.
std::vector<std::byte> bytesOfState(const tick::TickState& state);

/// "1:..." with the sizes of all parts: equal layouts can read each other's bytes.
std::string stateLayout();

/// program: that the state was made for. Problems: the bytes are not of such a state,
/// or of one that no servo can be in.
Result<tick::TickState> stateOfBytes(const std::vector<std::byte>& bytes, const tick::TickProgram& program);

}  // namespace underact::record
