#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/arm/preset.h"
#include "core/servo/device_port.h"
#include "core/servo/guard.h"
#include "core/system/thread_priority.h"
#include "device/remote/address.h"
#include "device/remote/arm_clock.h"
#include "device/remote/arm_side.h"
#include "device/remote/connection_limit.h"
#include "device/remote/keys.h"
#include "device/remote/message.h"
#include "device/remote/wire.h"

namespace underact::device::remote {

struct ShareOptions {
  Address listen;  // by default this computer only
  KeyPair keys;
  std::vector<std::string> clients;  // the keys that are admitted
  arm::Preset arm;                   // the samples have its joints
  int rate_hz = 1000;                // until a program asks for another
  bool allows_force = false;
  bool is_passive = true;
  std::string guard_program = {};  // underact-guard; empty: it is searched for
};

/// Shares an open arm: one remote program at a time reads it and, if allowed, commands forces. Every force passes a
/// gate here; it ends when none arrives for kQuietPeriods. A guard watches an arm that has a last command. Strangers
/// get no real time: the messages have the servo's priority only while a program has the arm, and not while connections
/// come faster than Knocks allows.
class Share {
 public:
  /// tell: gets a sentence for people about each event, from the network's thread. Problems: it cannot listen there; it
  /// is not limited to this computer, and no key is known.
  static Result<std::unique_ptr<Share>> open(std::unique_ptr<servo::DevicePort> port, const ShareOptions& options,
                                             std::function<void(const std::string&)> tell);
  ~Share();  // zero force, and the program that has it is told
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  Address address() const { return hub_->address(); }

 private:
  Share(std::unique_ptr<servo::DevicePort> port, const ShareOptions& options,
        std::function<void(const std::string&)> tell, std::unique_ptr<Hub> hub);
  Problems tickAt(int rate_hz);
  void putBackRate();
  void reportGuard();
  void run();
  void hear();
  void answer(const std::string& from, const Message& message);
  void welcome(const std::string& from, const Hello& hello);
  Problems makeReady(const Hello& hello);
  void refuse(const std::string& to, About about, const std::string& sentence);
  void leave(const std::string& sentence);
  void show();
  void poll();
  void countStrangers(std::int64_t now_ns);
  void checkGuard();
  std::string troubleNow();
  Welcome words() const;

  std::unique_ptr<servo::DevicePort> port_;
  const ShareOptions options_;
  const std::function<void(const std::string&)> tell_;
  std::unique_ptr<Hub> hub_;
  system::Doorbell bell_;
  int rate_hz_;
  std::unique_ptr<servo::Guard> guard_;
  Sentence no_guard_;  // why none was started
  std::unique_ptr<ArmSide> side_;
  std::unique_ptr<ArmClock> clock_;
  std::atomic<bool> ends_{false};
  // The network thread's.
  std::string seat_;  // the program that has the arm; empty: none
  std::uint64_t token_ = 0;
  std::int64_t heard_ns_ = 0;   // from that program
  std::int64_t looked_ns_ = 0;  // the state of the arm
  std::int64_t beats_ = 0, beat_ns_ = 0;
  std::uint64_t shown_ = 0;  // sequence of the sample sent last
  std::int64_t pauses_ = 0;
  bool pushed_ = false;     // and reported
  std::string trouble_;     // as reported
  bool is_guarded_ = true;  // as reported
  int replaced_ = 0;        // of the reported guards
  ConnectionLimit connection_limit_;
  bool is_storm_ = false;                // too many connections
  system::ThreadPriority before_storm_;  // of this thread
  bool is_hurried_ = false;
  int turned_away_ = 0;  // and not yet reported
  std::int64_t told_away_ns_ = 0;
  std::thread thread_;
};

/// Whether both are arms with the same joints.
bool isSame(const arm::Geometry& a, const arm::Geometry& b);

}  // namespace underact::device::remote
