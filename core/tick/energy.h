#pragma once
#include <cstddef>

#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"

namespace underact::tick {

// Inside the room: the energy of each constraint in step(), see core/control/passivity.h.

/// Updates the energy of the constraint at index and, where it is to stay passive, adds to its force. displacement_T_W:
/// the displacement of the tip since the last tick, m; zero where there was none. report.held[index] has the force of
/// its law.
void observeEnergy(const TickProgram& program, const control::LawInput& moment, const Vec3& displacement_T_W,
                   std::size_t index, TickState& state, TickReport& report) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
