#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/bindings/scene.h"
#include "core/record/recorder.h"
#include "core/servo/host.h"
#include "device/simulated_run.h"

namespace underact::bindings {

/// What a simulation is made from.
struct SimulationOptions {
  std::string hand;       // a built-in one; empty: Python says where it wants to be
  std::string hand_text;  // instead: the content of a hand file
  int rate_hz = 1000;
  std::uint64_t seed = 1;
  std::string arm_model;
  std::string record;  // a new session file; empty: none
  std::string name;    // of the session
  bool details = false;
};

/// The servo and the simulated arm in lockstep, as of `underact-cli run --fast`: the same numbers, tick by tick. One
/// thread at a time.
class Simulation {
 public:
  /// Problems: those of the hand, the arm model, the scene, the file of the session.
  static Result<std::unique_ptr<Simulation>> make(const Scene& scene, const SimulationOptions& options);

  void run(std::int64_t ticks);
  /// Where the hand wants the tip, m; R_WT null: the wrist stays as it is. It gets there within some 15 ms.
  void want(const Vec3& p_WT, const Mat3* R_WT);
  void letGo(bool lets_go) { arm_->holdStylus(!lets_go); }
  void push(const Vec3& f_T_W, std::int64_t ticks) { host_->push(f_T_W, ticks); }
  void startServo() { host_->start(); }
  void stopServo() { host_->stop(); }
  /// Problems: as Host::edit().
  Problems edit(const Scene& scene);
  void mark(const std::string& label);
  /// Ends the recording. Problems: what is missing.
  Problems close();

  /// The ticks since the start, or since forget().
  const std::vector<servo::TickRecord>& ticks() const { return ticks_; }
  void forget() { ticks_.clear(); }
  const servo::TickRecord& last() const { return last_; }
  std::int64_t count() const { return count_; }
  int rateHz() const { return host_->rateHz(); }
  const arm::Geometry& geometry() const { return geometry_; }
  /// Whether a thread is in run(), which others hear of instead of waiting. Read and set with the interpreter's lock.
  bool is_busy = false;
  bool keeps = true;  // ticks()

 private:
  Simulation() = default;
  device::SimulatedArm* arm_ = nullptr;  // of the host
  std::unique_ptr<servo::Host> host_;
  std::unique_ptr<record::Recorder> recorder_;  // goes before the host
  arm::Geometry geometry_;
  std::vector<servo::TickRecord> ticks_;
  servo::TickRecord last_;
  std::int64_t count_ = 0;
};

}  // namespace underact::bindings

template <>
struct pybind11::detail::type_caster<underact::bindings::Simulation>
    : underact::bindings::MadeCaster<underact::bindings::Simulation> {};
