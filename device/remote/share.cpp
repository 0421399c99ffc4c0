#include "device/remote/share.h"

#include <cmath>
#include <utility>

#include "core/system/thread.h"

namespace underact::device::remote {
namespace {

constexpr int kWait_ms = 5;
constexpr std::int64_t kSilent_ns = 200'000'000;       // then the arm is free for others
constexpr std::int64_t kPollEvery_ns = 50'000'000;     // at the trouble that the arm reports
constexpr std::int64_t kStandsStill_ns = 100'000'000;  // as the servo's watchdog
constexpr std::int64_t kFarewell_ns = 50'000'000;      // time for the last messages to get through
constexpr std::int64_t kTellEvery_ns = 1'000'000'000;  // how many were refused
constexpr double kAlike_m = 1e-9;                      // one was read from mm

}  // namespace

bool isSame(const arm::Geometry& a, const arm::Geometry& b) {
  return std::abs(a.upper_m - b.upper_m) < kAlike_m && std::abs(a.fore_m - b.fore_m) < kAlike_m &&
         (a.p_WB - b.p_WB).norm() < kAlike_m;
}

Result<std::unique_ptr<Share>> Share::open(std::unique_ptr<servo::DevicePort> port, const ShareOptions& options,
                                           std::function<void(const std::string&)> tell) {
  if (!options.listen.isThisMachine() && options.clients.empty())
    return Problems{
        {"Nobody's key is allowed, so nobody at another computer could use the arm. There, \"underact-cli "
         "share-arm --show-key\" prints the line to run here.",
         {}}};
  std::vector<std::string> allowed = options.clients;
  if (options.listen.isThisMachine()) allowed.push_back(options.keys.public_key);  // this user's own programs
  Result<std::unique_ptr<Hub>> hub = Hub::open(options.listen, options.keys, std::move(allowed));
  if (!hub) return hub.problems();
  std::unique_ptr<Share> share(new Share(std::move(port), options, std::move(tell), std::move(hub).value()));
  const Problems problems = share->tickAt(options.rate_hz);
  if (!problems.empty()) return problems;
  share->reportGuard();
  share->thread_ = std::thread(&Share::run, share.get());
  return share;
}

Share::Share(std::unique_ptr<servo::DevicePort> port, const ShareOptions& options,
             std::function<void(const std::string&)> tell, std::unique_ptr<Hub> hub)
    : port_(std::move(port)),
      options_(options),
      tell_(std::move(tell)),
      hub_(std::move(hub)),
      rate_hz_(options.rate_hz) {}

Share::~Share() {
  ends_ = true;
  bell_.ring();
  if (thread_.joinable()) thread_.join();
  clock_.reset();
  if (seat_.empty()) return;
  refuse(seat_, About::Ended,
         "It is no longer shared, because the sharing program at its computer has ended. Start it anew and press "
         "Restart.");
  // A socket that is closed with unread messages drops the connection, and the last message with it.
  std::string from;
  Bytes bytes;
  for (const std::int64_t end_ns = system::monotonicNow_ns() + kFarewell_ns; system::monotonicNow_ns() < end_ns;) {
    hub_->wait(-1, 1);
    while (hub_->receive(from, bytes)) continue;
  }
}

/// The arm ticks again; no program has it meanwhile.
Problems Share::tickAt(int rate_hz) {
  Result<ArmSide::Options> options = optionsOf(options_.arm, port_->info(), rate_hz);
  if (!options) return options.problems();
  options.value().allows_force = options_.allows_force;
  options.value().is_passive = options_.is_passive;
  clock_.reset();
  rate_hz_ = rate_hz;
  guard_.reset();  // another arm may be in its place, with another descriptor
  side_ = std::make_unique<ArmSide>(*port_, options.value(), bell_);
  guard_ = servo::Guard::start(port_->zeroForceMessage(), kStandsStill_ns, options_.guard_program, no_guard_);
  if (guard_) side_->countInto(guard_->beats());
  replaced_ = 0;
  shown_ = 0;
  pauses_ = 0;
  beats_ = 0;
  beat_ns_ = system::monotonicNow_ns();
  clock_ = std::make_unique<ArmClock>(*port_, *side_, rate_hz);
  return {};
}

/// As it was before a program asked for another rate; no program has the arm.
void Share::putBackRate() {
  if (rate_hz_ == options_.rate_hz) return;
  clock_.reset();
  port_->setRate(options_.rate_hz);
  const Problems problems = tickAt(options_.rate_hz);
  if (!problems.empty()) tell_(problems.front().sentence);  // impossible: it has ticked at this rate
}

void Share::reportGuard() {
  is_guarded_ = guard_ != nullptr;
  if (guard_)
    tell_("A guard watches the arm: if this program crashes, the guard still commands zero force.");
  else if (port_->zeroForceMessage().fd >= 0)
    tell_(servo::noGuardText(no_guard_));
}

void Share::run() {
  system::nameThread("underact-share");
  system::askForRealTime({}, rate_hz_);
  while (!ends_.load(std::memory_order_relaxed)) {
    hub_->wait(bell_.descriptor(), kWait_ms);
    bell_.clear();
    hear();
    show();
    const std::int64_t now_ns = system::monotonicNow_ns();
    if (!seat_.empty() && now_ns - heard_ns_ > kSilent_ns) leave("The program that had the arm stopped sending.");
    if (now_ns - looked_ns_ > kPollEvery_ns) {
      looked_ns_ = now_ns;
      poll();
      countStrangers(now_ns);
      checkGuard();
    }
    const bool is_urgent = !seat_.empty() && !is_storm_;
    if (std::exchange(is_hurried_, is_urgent) != is_urgent) hub_->setUrgent(is_urgent);
  }
}

void Share::hear() {
  std::string from;
  Bytes bytes;
  while (hub_->receive(from, bytes)) {
    const std::optional<Message> message = readMessage(bytes);
    const std::optional<int> version = versionOf(bytes);
    if (message) {
      answer(from, *message);
    } else if (version && *version != kVersion) {
      refuse(from, About::Refusal,
             "It is shared with version " + std::to_string(kVersion) + " of the protocol, and this program speaks " +
                 std::to_string(*version) + ". Install the same release of Underact at both ends.");
    }
  }
}

void Share::answer(const std::string& from, const Message& message) {
  if (const Hello* const hello = std::get_if<Hello>(&message)) return welcome(from, *hello);
  if (from != seat_ || seat_.empty()) {
    if (std::get_if<ForceMessage>(&message) != nullptr)
      refuse(from, About::InUse,
             seat_.empty() ? "The arm was released because nothing came from this program for 0.2 s. Press Restart."
                           : "Another program has it now.");
    return;
  }
  if (const ForceMessage* const force = std::get_if<ForceMessage>(&message)) {
    heard_ns_ = system::monotonicNow_ns();
    side_->take(*force);
  } else if (std::get_if<Bye>(&message) != nullptr) {
    leave("The program that had the arm has released it.");
  }
}

void Share::refuse(const std::string& to, About about, const std::string& sentence) {
  hub_->send(to, bytesOf(Words{about, sentence}));
}

Welcome Share::words() const {
  const servo::DeviceInfo info = port_->info();
  const ArmSide::Options options = optionsOf(options_.arm, info, rate_hz_).value();
  return {rate_hz_,
          options_.allows_force,
          options_.is_passive,
          true,
          options.limits.max_force_N,
          info.frozen_s,
          {options_.arm.name, options_.arm.geometry},
          info.title};
}

void Share::welcome(const std::string& from, const Hello& hello) {
  if (hello.only_looks) {
    hub_->send(from, bytesOf(words()));
    return;
  }
  if (!isSame(hello.arm.geometry, options_.arm.geometry)) {
    refuse(from, About::OtherArm,
           "It is shared with the joints of \"" + options_.arm.name + "\", but the scene is for \"" + hello.arm.preset +
               "\". Share it with --arm " + hello.arm.preset + ", or open a scene for " + options_.arm.name + ".");
    return;
  }
  if (!seat_.empty() && hello.token != token_) {
    refuse(from, About::InUse, "It is in use by another program. Only one at a time can have it.");
    return;
  }
  const Problems problems = makeReady(hello);
  if (!problems.empty()) {
    if (seat_.empty()) putBackRate();
    return refuse(from, About::Refusal, problems.front().sentence);
  }
  if (seat_.empty() || seat_ != from)
    tell_("A program has the arm" + std::string(options_.allows_force ? "." : ", without force."));
  seat_ = from;
  token_ = hello.token;
  heard_ns_ = system::monotonicNow_ns();
  pushed_ = false;
  side_->seat(true);
  hub_->send(from, bytesOf(words()));
  trouble_.clear();
}

/// A lost arm is reopened, since that is what Restart at the other end asks for.
Problems Share::makeReady(const Hello& hello) {
  const bool is_lost = !port_->trouble().empty();
  if (hello.rate_hz < servo::kSlowest_hz || hello.rate_hz > servo::kFastest_hz)
    return {{"A shared arm ticks " + std::to_string(servo::kSlowest_hz) + " to " + std::to_string(servo::kFastest_hz) +
                 " times a second, but the program that asks wants " + std::to_string(hello.rate_hz) +
                 ". Choose another rate there.",
             {}}};
  if (hello.rate_hz != rate_hz_) {
    const std::string why = port_->rateRefusal(hello.rate_hz);
    if (!why.empty())
      return {{"It is shared at " + std::to_string(rate_hz_) + " Hz, but the program that asks ticks at " +
                   std::to_string(hello.rate_hz) + " Hz. " + why,
               {}}};
  }
  if (!is_lost && hello.rate_hz == rate_hz_) return {};
  clock_.reset();
  if (hello.rate_hz != rate_hz_) port_->setRate(hello.rate_hz);
  Problems problems = is_lost ? port_->reopen() : Problems{};
  const Problems more = tickAt(hello.rate_hz);
  problems.insert(problems.end(), more.begin(), more.end());
  return problems;
}

void Share::leave(const std::string& sentence) {
  side_->seat(false);
  seat_.clear();
  putBackRate();
  tell_(sentence + " Zero force, free for the next program.");
}

/// The newest sample to the program that has the arm; and rare changes to people.
void Share::show() {
  const ArmSide::Shown& shown = side_->shown();
  if (seat_.empty() || shown.sample.sequence == shown_) return;
  shown_ = shown.sample.sequence;
  SampleMessage message = shown.sample;
  for (double& angle_rad : message.sample.q_rad) {
    if (!std::isfinite(angle_rad)) angle_rad = 0.0;  // then it has no sample
  }
  hub_->send(seat_, bytesOf(message));
  if (shown.f_T_W != Vec3::Zero() && !std::exchange(pushed_, true)) tell_("It pushes.");
  if (std::exchange(pauses_, shown.pauses) < shown.pauses)
    tell_("No force received: zero after " + std::to_string(shown.max_unfresh) + " more periods at most.");
}

std::string Share::troubleNow() {
  const std::string words = port_->trouble();
  if (!words.empty()) return words;
  return describe(side_->shown().fault);
}

/// The arm's trouble; and a watchdog for its ticks.
void Share::poll() {
  const std::int64_t now_ns = system::monotonicNow_ns();
  const std::int64_t beats = side_->beats();
  if (std::exchange(beats_, beats) != beats) beat_ns_ = now_ns;
  if (now_ns - beat_ns_ > kStandsStill_ns) port_->cut();
  std::string trouble = troubleNow();
  if (trouble == trouble_) return;
  if (!trouble.empty()) tell_(trouble);
  trouble_ = std::move(trouble);
  if (!seat_.empty()) refuse(seat_, About::Trouble, trouble_);
}

/// While there are too many, refusing them is not urgent work either. Reported at most once a second.
void Share::countStrangers(std::int64_t now_ns) {
  connection_limit_.count(hub_->connections(), now_ns);
  const bool is_storm = connection_limit_.areTooMany();
  if (std::exchange(is_storm_, is_storm) != is_storm) {
    if (is_storm) {
      before_storm_ = system::ownPriority();
      system::setOwnPriority({});
    } else if (!system::setOwnPriority(before_storm_)) {
      system::askForRealTime({}, rate_hz_);  // the other program could take it away
    }
  }
  turned_away_ += hub_->rejected();
  if (turned_away_ == 0 || now_ns - told_away_ns_ < kTellEvery_ns) return;
  told_away_ns_ = now_ns;
  const int times = std::exchange(turned_away_, 0);
  tell_("A program whose key is not allowed was refused" +
        (times == 1 ? std::string() : ", " + std::to_string(times) + " times") + ". Use --allow KEY to admit it.");
}

/// A gap may be over before it is seen here: then who was replaced says so. After another rate there may be none.
void Share::checkGuard() {
  if (guard_ == nullptr && port_->zeroForceMessage().fd < 0) return;
  const Sentence gap = guard_ ? guard_->gap() : no_guard_;
  const int replaced = guard_ ? guard_->replaced() : 0;
  if (!gap.empty()) {
    if (std::exchange(is_guarded_, false)) tell_(servo::noGuardText(gap));
    return;
  }
  const bool was_replaced = std::exchange(replaced_, replaced) != replaced;
  if (!std::exchange(is_guarded_, true) || was_replaced)
    tell_("The arm's guard had ended and was replaced by another one.");
}

}  // namespace underact::device::remote
