#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/scene_file.h"
#include "core/servo/host.h"
#include "core/sim/arm_model.h"
#include "core/system/private_file.h"
#include "core/system/scheduling.h"
#include "device/simulated_run.h"

namespace underact::cli {

// A scene on an arm that somebody holds: what `run` and `serve` have in common.

/// Which scene, which arm, and by whom it is held.
struct HeldArm {
  std::string scene;
  std::string hand;
  std::optional<double> mass_kg, damping_N_s_per_m, stiffness_N_per_m;  // of the hand; none: its own
  int rate_hz = 1000;
  int max_late = 20;
  bool fast = false;
  std::uint64_t seed = 1;
  std::string space;  // empty: the scene's
  bool left_handed = false;
  std::vector<std::string> overrides;  // of the scene's settings, PATH=VALUE
  std::string arm_model{sim::kDefaultArmModel};
  std::string device{"simulated"};
  system::SchedulingRequest scheduling;
  std::string record;      // the file of the recording; empty: none
  bool overwrite = false;  // it may exist
  bool isSimulated() const;
  system::Existing existing() const { return overwrite ? system::Existing::Replace : system::Existing::Refuse; }
};

/// The options, read.
struct Prepared {
  LoadedScene scene;
  device::SimulatedRun run;  // of the simulated arm
};

// The options, in the order in which --help has them.
void addHandOptions(Command command, HeldArm& options);
void addRateOptions(Command command, HeldArm& options);
void addSeedOption(Command command, HeldArm& options);
void addArmOptions(Command command, HeldArm& options);

/// Checks what is asked for, the file of the recording too, and reads it, in this order. ticks: for how many it runs.
/// Empty: something was wrong; it has been printed, and exit is its status.
std::optional<Prepared> prepare(const HeldArm& options, std::int64_t ticks, const Streams& streams, Exit& exit);

/// The arm, open. Problems: there is none; it cannot be opened.
Result<std::unique_ptr<servo::DevicePort>> openArm(const HeldArm& options, const Prepared& prepared);

/// No folders of a person are in a session.
std::string fileName(const std::string& path);

}  // namespace underact::cli
