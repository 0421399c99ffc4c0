#pragma once
#include <cstddef>

#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"

namespace underact::tick {

// Inside the room: what step() does for the energy of each constraint, see core/control/passivity.h.

/// Counts the energy of the constraint at index and, where it is to stay passive, adds to its force. way_T_W: of the
/// tip since the last tick, m; zero where there was none. report.held[index] has the force that its law asks for.
void watchEnergy(const TickProgram& program, const control::Moment& moment, const Vec3& way_T_W, std::size_t index,
                 TickState& state, TickReport& report) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
