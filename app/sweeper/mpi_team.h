#pragma once
#include <memory>

#include "core/base/result.h"
#include "core/sweep/team.h"

namespace underact::sweep {

/// Whether mpirun, or a scheduler that stands in for it, has started this program as one of several. Otherwise MPI is
/// not initialised at all: a program on its own needs no daemon, no network and no shell on another machine.
bool isOneOfTeam();

/// The ranks that mpirun started. Once per program. Problems: MPI could not be started; this program was built without
/// it.
Result<std::unique_ptr<Team>> joinTeam();

/// "Open MPI v4.1.4" or the like; "none" where the program was built without.
const char* mpiVersion();

}  // namespace underact::sweep
