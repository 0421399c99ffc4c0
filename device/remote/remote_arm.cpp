#include "device/remote/remote_arm.h"

#include <algorithm>
#include <random>
#include <utility>

#include "core/base/translate.h"
#include "core/system/thread.h"

namespace underact::device::remote {
namespace {

constexpr int kConnect_ms = 3000;
constexpr int kBusyAsks = 15, kBusyPause_ms = 100;  // a program that has just ended still counts for a moment
constexpr std::int64_t kLost_ns = 1'000'000'000;    // silence, after which the connection is considered lost
constexpr int kSilentReads = 20;                    // in a row without a sample; after more, the gate gives up

}  // namespace

Result<std::unique_ptr<RemoteArm>> RemoteArm::open(const Endpoint& endpoint, const arm::Preset& arm, int rate_hz) {
  std::unique_ptr<RemoteArm> opened(new RemoteArm(endpoint, arm, rate_hz));
  const Problems problems = opened->connect();
  if (!problems.empty()) return problems;
  return opened;
}

RemoteArm::RemoteArm(Endpoint endpoint, const arm::Preset& arm, int rate_hz)
    : endpoint_(std::move(endpoint)), arm_(arm), rate_hz_(rate_hz), period_ns_(1'000'000'000 / std::max(rate_hz, 1)) {
  std::random_device random;  // not a secret: it tells one program from another
  token_ = (static_cast<std::uint64_t>(random()) << 32U) | random();
}

RemoteArm::~RemoteArm() {
  disconnect();
}

Problems RemoteArm::connect() {
  Result<std::unique_ptr<Wire>> wire = connectTo(endpoint_, kConnect_ms);
  if (!wire) return wire.problems();
  Result<Welcome> welcome = ask(*wire.value());
  if (!welcome) return welcome.problems();
  if (welcome.value().rate_hz != rate_hz_)
    return {{phrase(TRANSLATE_NOOP("problem", "The arm at %1 ticks at %2 Hz, not at %3 Hz."),
                    {endpoint_.address.text(), std::to_string(welcome.value().rate_hz), std::to_string(rate_hz_)}),
             {}}};
  wire_ = std::move(wire).value();
  {
    const std::scoped_lock lock(words_mutex_);
    welcome_ = welcome.value();
    loss_.clear();
    trouble_.clear();
  }
  ++line_;
  sequence_ = 0;
  came_ns_ = wrote_ns_ = sent_ns_ = system::monotonicNow_ns();
  ends_ = false;
  is_lost_ = false;
  missed_ = 0;
  thread_ = std::thread(&RemoteArm::run, this);
  return {};
}

Result<Welcome> RemoteArm::ask(Wire& wire) {
  const Hello hello{token_, rate_hz_, false, {arm_.name, arm_.geometry}};
  Result<Welcome> welcome = Problems{};
  for (int ask = 0; ask < kBusyAsks; ++ask) {
    bool is_busy = false;
    welcome = awaitWelcome(wire, hello, endpoint_.address, kConnect_ms, is_busy);
    if (!is_busy) break;
    wire.wait(-1, 0);
    system::sleepUntil(system::monotonicNow_ns() + kBusyPause_ms * kMillisecond_ns);
  }
  return welcome;
}

void RemoteArm::disconnect() {
  ends_ = true;
  wrote_.ring();
  if (thread_.joinable()) thread_.join();
  if (wire_) wire_->send(bytesOf(Bye{}));
  wire_.reset();
}

Problems RemoteArm::reopen() {
  disconnect();
  Problems problems = connect();
  if (problems.empty()) return problems;
  {
    const std::scoped_lock lock(words_mutex_);
    loss_.clear();
  }
  lose(problems.front().sentence);
  return problems;
}

void RemoteArm::lose(Sentence sentence) {
  {
    const std::scoped_lock lock(words_mutex_);
    if (loss_.empty()) loss_ = std::move(sentence);
  }
  is_lost_ = true;
  came_.ring();
}

void RemoteArm::run() {
  system::nameThread("underact-net");
  system::askForRealTime({}, rate_hz_);
  const auto wait_ms = static_cast<int>(std::max<std::int64_t>(kQuietTicks * period_ns_ / kMillisecond_ns, 1));
  while (!ends_ && !is_lost_) {
    wire_->wait(wrote_.descriptor(), wait_ms);
    wrote_.clear();
    hear();
    const std::int64_t now_ns = system::monotonicNow_ns();
    speak(now_ns);
    const bool is_broken = wire_->state() != LineState::Connected;
    if (is_broken) hear();  // the reason, if it was sent
    if (is_broken)
      lose(phrase(
          TRANSLATE_NOOP("problem",
                         "The connection to the arm at %1 was lost. Check the network and the sharing program on "
                         "its computer, then press Restart."),
          {endpoint_.address.text()}));
    else if (now_ns - came_ns_ > kLost_ns)
      lose(phrase(TRANSLATE_NOOP("problem",
                                 "The arm at %1 no longer sends anything. Check the network and the sharing program on "
                                 "its computer, then press Restart."),
                  {endpoint_.address.text()}));
  }
  if (is_lost_) wire_.reset();  // late messages are ignored
}

/// The newest of all that arrived.
void RemoteArm::hear() {
  const std::uint64_t before = sequence_;
  while (wire_->receive(bytes_)) {
    const std::optional<Message> message = readMessage(bytes_);
    if (!message) continue;
    if (const SampleMessage* const sample = std::get_if<SampleMessage>(&*message)) {
      if (sample->sequence <= sequence_) continue;
      sequence_ = sample->sequence;
      taken_.back().message = *sample;
    } else if (const Words* const words = std::get_if<Words>(&*message)) {
      hear(*words);
    }
  }
  if (sequence_ == before) return;
  Taken& taken = taken_.back();
  taken.number = ++samples_;
  taken.came_ns = system::monotonicNow_ns();
  taken.line = line_;
  came_ns_ = taken.came_ns;
  taken_.publish();
  came_.ring();
}

void RemoteArm::hear(const Words& words) {
  if (words.about != About::Trouble) return lose(ofArmAt(endpoint_.address, words.text));
  const std::scoped_lock lock(words_mutex_);
  trouble_ = words.text;
}

/// The tick's last force, once; zero if it is cut, or if the tick wrote nothing for long.
void RemoteArm::speak(std::int64_t now_ns) {
  const ForceMessage& wanted = wanted_.latest();
  const bool is_new = wanted.number != sent_;
  if (is_new) wrote_ns_ = now_ns;
  sent_ = wanted.number;
  const bool is_cut = is_cut_.load(std::memory_order_acquire);
  const std::int64_t quiet_ns = kQuietTicks * period_ns_;
  const bool is_quiet = now_ns - wrote_ns_ >= quiet_ns && now_ns - sent_ns_ >= quiet_ns;
  if (!is_new && !is_quiet && !is_cut) return;
  ForceMessage message;
  if (is_new && !is_cut) message = wanted;
  if (!is_new || is_cut) message.answered = sequence_;
  message.number = ++forces_;
  wire_->send(bytesOf(message));
  sent_ns_ = now_ns;
}

std::int64_t RemoteArm::staleAfter_ns() const noexcept {
  return std::max(kStale_ns, kStalePeriods * period_ns_);
}

bool RemoteArm::read(arm::Sample& sample) noexcept {
  const std::int64_t half_ns = period_ns_ / 2;
  const Taken* taken = &taken_.latest();
  if (taken->number == number_ && !is_lost_.load(std::memory_order_relaxed)) {
    came_.waitFor(half_ns);
    taken = &taken_.latest();
  }
  const bool is_new = taken->number != number_;
  number_ = taken->number;
  const std::int64_t age_ns = system::monotonicNow_ns() - taken->came_ns;
  if (number_ == 0 || taken->line != line_ || age_ns > staleAfter_ns() || is_lost_.load(std::memory_order_relaxed) ||
      !taken->message.has_sample) {
    missed_.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  missed_.store(0, std::memory_order_relaxed);
  answered_ = taken->message.sequence;
  sample = taken->message.sample;
  // On the arm's own clock, which restarts with each connection and never runs back; a sample that is kept grows older.
  const std::int64_t own_ns = sample.time_ns + (is_new ? 0 : age_ns);
  if (std::exchange(seen_line_, line_) != line_) ahead_ns_ = time_ns_ + period_ns_ - own_ns;
  time_ns_ = std::max(own_ns + ahead_ns_, time_ns_ + half_ns);
  sample.time_ns = time_ns_;
  sample.epoch += line_;
  return true;
}

void RemoteArm::write(const safety::GatedForce& force) noexcept {
  ForceMessage& wanted = wanted_.back();
  wanted.number = ++writes_;
  wanted.answered = answered_;
  wanted.f_T_W = force.f_T_W();
  wanted.pushes = true;
  wanted_.publish();
  is_cut_.store(false, std::memory_order_release);
  wrote_.ring();
}

void RemoteArm::cut() noexcept {
  is_cut_.store(true, std::memory_order_release);
  wrote_.ring();
}

Sentence RemoteArm::fixedRateReason() const {
  return phrase(TRANSLATE_NOOP("problem",
                               "The arm at %1 keeps the rate that it was opened with. Choose the simulated arm, then "
                               "the rate, and open it again."),
                {endpoint_.address.text()});
}

Sentence RemoteArm::trouble() const {
  const std::scoped_lock lock(words_mutex_);
  if (!loss_.empty()) return loss_;
  if (!trouble_.empty()) return ofArmAt(endpoint_.address, trouble_);
  if (missed_ >= kSilentReads)
    return phrase(
        TRANSLATE_NOOP(
            "problem",
            "The arm at %1 no longer sends anything. Check the network and the sharing program on its computer."),
        {endpoint_.address.text()});
  return {};
}

std::vector<std::string> RemoteArm::listing() const {
  const std::scoped_lock lock(words_mutex_);
  return {"shared at " + endpoint_.address.text() + ", " + std::to_string(welcome_.rate_hz) + " Hz",
          welcome_.allows_force ? "force allowed" : "no force allowed",
          welcome_.is_passive ? "kept passive at the arm" : "not kept passive", "joints of " + welcome_.arm.preset};
}

servo::DeviceInfo RemoteArm::info() const {
  const std::scoped_lock lock(words_mutex_);
  const char* const title = welcome_.allows_force ? TRANSLATE_NOOP("problem", "%1 at %2")
                                                  : TRANSLATE_NOOP("problem", "%1 at %2, without force");
  return {phrase(title, {welcome_.title, endpoint_.address.text()}), false, true, welcome_.frozen_s};
}

}  // namespace underact::device::remote
