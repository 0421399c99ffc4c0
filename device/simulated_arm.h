#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "core/servo/device_port.h"
#include "core/servo/slot.h"
#include "core/sim/hand_script.h"
#include "core/sim/plant.h"

namespace underact::device {

/// Where the tip rests in a new window, and where a lesson's scripted hand finds it: on the sphere of the first start,
/// where there is no force yet.
inline const Vec3 kFirst_p_WT(0.0, 0.0, 0.05);

/// A simulated arm: its joints, encoders, friction and mass, held by a hand. Each read() is one period later, whatever
/// the wall clock says, so it runs live and faster than real time with the same numbers.
class SimulatedArm final : public servo::DevicePort {
 public:
  struct Options {
    arm::Preset arm;
    sim::ArmModel model;
    sim::HandModel hand;
    int rate_hz = 1000;
    std::optional<Vec3> start_p_WT = {};  // where the tip rests at first; none: where it does by itself
    Integration integration = {};
  };
  explicit SimulatedArm(const Options& options);

  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME override;
  void write(const safety::GatedForce& force) noexcept UNDERACT_REAL_TIME override;
  bool truth(servo::Truth& truth) const noexcept UNDERACT_REAL_TIME override;
  void cut() noexcept UNDERACT_REAL_TIME override;
  servo::DeviceInfo info() const override;
  Sentence fixedRateReason() const override { return {}; }
  void setRate(int rate_hz) override;

  /// Whether the stylus button nearer to the tip (bit 0 of a sample's buttons) is held, from the next read() on. Any
  /// thread.
  void holdButton(bool held) { button_.store(held, std::memory_order_relaxed); }
  /// Holds all buttons, from a controller, in addition to holdButton(): bits of a sample's buttons. Any thread.
  void holdButtons(unsigned bits) { buttons_.store(bits, std::memory_order_relaxed); }

  /// The model of the arm from the next read() on. Any one thread, never blocks the servo.
  void become(const sim::ArmModel& model);
  /// Takes on geometry, limits and encoders: those of the arm that the scene is for. The samples begin a new epoch;
  /// where either arm does not solvesInTick(), at rest, with the hand there. The thread that calls become().
  void become(const arm::Preset& arm);
  /// From the next read() on the arm stands at rest with these joints (rad or m, brought within their limits), and the
  /// hand is there; none: where the arm began, or rests. The samples begin a new epoch. A script does not end. The
  /// thread that calls become().
  void standAt(const std::optional<arm::JointAngles>& q);
  /// The hand lets go of the stylus (holds false) or grips it again, from the next read() on. Any thread.
  void holdStylus(bool holds) { let_go_.store(!holds, std::memory_order_relaxed); }

  /// How the arm is integrated from the next read() on. Any thread.
  void integrate(const Integration& integration) noexcept;

  /// The hand follows a script from the next read() on; if that is the first read, the arm rests where the script
  /// begins. Only before the servo thread starts.
  void follow(sim::HandScript script);
  /// Where the hand wants to be from the next read() on: the input of the mouse. It gets there within some 15 ms, so
  /// that a jump of the mouse is not an infinite velocity; v_WT is not used. Any one thread, never blocks the
  /// servo; ends a script.
  void setSetpoint(const sim::HandSetpoint& setpoint);
  /// Where a hand that is told its places now and then, 10 or 1000 times a second, wants to be: from one to the next it
  /// moves uniformly in 1.1 times what passed between the last two, so that one that comes a little late does not stop
  /// it; at most in kLongestGlide_ns.
  void glideTo(const sim::HandSetpoint& setpoint);
  static constexpr std::int64_t kLongestGlide_ns = 110'000'000;
  /// Where the hand wants to be by the last setpoint(), or where the arm starts. The thread that calls setpoint().
  const sim::HandSetpoint& setpoint() const { return last_setpoint_; }

 private:
  /// The numbers of a model and of an arm, without their texts.
  struct Figures {
    double mass_kg = 0.0, friction_N = 0.0, damping_N_s_per_m = 0.0;
    bool encoders = true;
    bool of_links = false;
    arm::EncoderCounts counts_per_turn{};
    arm::Geometry geometry;
    arm::JointLimits limits;
    std::uint32_t arms = 0;  // how many there were before this one
    bool rests = false;      // it begins at rest, not where the last one was
    sim::PlantState rest = {};
  };
  /// A setpoint as it is handed to the servo thread.
  struct Wish {
    sim::HandSetpoint setpoint;
    std::uint32_t number = 0;
    bool glides = false;
  };
  /// Where a hand is on its way to the latest wish.
  struct Glide {
    std::uint32_t number = 0;  // of that wish
    Vec3 p_WT = Vec3::Zero();
    std::int64_t told_ns = 0, arrives_ns = 0;
  };
  void wish(const sim::HandSetpoint& setpoint, bool glides);
  sim::HandSetpoint glided(const Wish& wish) noexcept UNDERACT_REAL_TIME;
  sim::PlantState standing(const std::optional<arm::JointAngles>& q) const;
  void publish();
  void takeUp() noexcept UNDERACT_REAL_TIME;

  sim::Plant plant_;
  arm::Preset wanted_arm_;  // these two: of the thread that calls become()
  sim::ArmModel wanted_model_;
  std::uint32_t arms_ = 0, epoch_ = 0;
  bool rests_ = false;    // of the thread that calls become(), as the next three
  sim::PlantState rest_;  // where, if it rests
  const std::optional<Vec3> start_p_WT_;
  std::vector<std::shared_ptr<const arm::Mechanism>> kept_;  // all that there were: the servo thread never frees one
  sim::HandModel hand_;                                      // while it holds the stylus
  std::atomic<bool> let_go_{false};
  servo::Slot<Figures> figures_;
  std::atomic<bool> has_figures_{false};
  std::atomic<std::int64_t> integration_;  // packed
  sim::PlantState state_;
  std::int64_t period_ns_;
  std::int64_t time_ns_ = 0;  // of the last read
  Vec3 f_T_W_ = Vec3::Zero(), m_T_W_ = Vec3::Zero();
  std::atomic<bool> is_cut_{false};
  std::atomic<bool> button_{false};
  std::atomic<unsigned> buttons_{0};
  sim::HandScript script_;
  std::int64_t script_start_ns_ = 0;
  bool scripted_ = false;
  sim::HandSetpoint heeded_;  // the hand's wish in this period: from the script, or from the mouse, smoothed
  sim::HandSetpoint last_setpoint_;
  servo::Slot<Wish> wishes_;
  std::uint32_t wishes_made_ = 0;  // of the thread that calls setSetpoint()
  Glide glide_;
  std::atomic<bool> has_setpoint_{false};
};

}  // namespace underact::device
