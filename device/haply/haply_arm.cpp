#include "device/haply/haply_arm.h"

#include <algorithm>
#include <utility>

#include "core/arm/haply_frame.h"
#include "core/arm/inverse.h"
#include "core/base/translate.h"
#include "core/json/json.h"
#include "core/system/thread.h"

namespace underact::device::haply {
namespace {

constexpr int kAnswer_ms = 3000;
constexpr std::int64_t kSilence_ns = 1'000'000'000;  // after it the arm is given up
constexpr int kSilentStates = 20;                    // reads in a row without one; after more, the gate gives up
// Its encoders' steps are 0.01 mm at the cursor: a hand that holds it crosses many per second.
constexpr double kStill_s = 1.0;

std::int64_t periodAt(int rate_hz) {
  return 1'000'000'000 / std::max(rate_hz, 1);
}

std::string namesOf(const std::vector<std::string>& ids) {
  std::string names;
  for (const std::string& id : ids) names += (names.empty() ? "" : ", ") + id;
  return names;
}

}  // namespace

Result<std::unique_ptr<HaplyArm>> HaplyArm::open(const Place& place, const arm::Geometry& arm, int rate_hz) {
  std::unique_ptr<HaplyArm> opened(new HaplyArm(place, arm, rate_hz));
  const Problems problems = opened->connect();
  if (!problems.empty()) return problems;
  return opened;
}

HaplyArm::HaplyArm(Place place, const arm::Geometry& arm, int rate_hz)
    : place_(std::move(place)), arm_(arm), period_ns_(periodAt(rate_hz)) {
  opened_ns_ = system::monotonicNow_ns();
}

HaplyArm::~HaplyArm() {
  disconnect();
}

Problems HaplyArm::connect() {
  form_ = formOf(getOverHttp(place_, "/version", kAnswer_ms));
  Result<std::unique_ptr<Line>> line = Line::open(place_, kAnswer_ms);
  if (!line) return line.problems();
  line_ = std::move(line).value();
  ++epoch_;
  if (Problems problems = awaitFirst(); !problems.empty()) {
    line_.reset();
    return problems;
  }
  ends_ = false;
  loss_ = Loss::None;
  missed_ = 0;
  unanswered_ = 0;
  sent_ = wanted_.latest().number;  // a force for a lost connection is not sent on this one
  sent_ns_ = wrote_ns_ = system::monotonicNow_ns();
  thread_ = std::thread(&HaplyArm::run, this);
  return {};
}

/// Waits until the service has said where the arm is.
Problems HaplyArm::awaitFirst() {
  Told told;
  told.id = place_.id;
  line_->send(greetingText(form_));
  const std::int64_t end_ns = system::monotonicNow_ns() + 1'000'000 * std::int64_t{kAnswer_ms};
  Heard heard = Heard::Nothing;
  while (heard != Heard::Place && line_->isOpen() && system::monotonicNow_ns() < end_ns) {
    line_->wait(-1, 10);
    while (heard != Heard::Place && line_->receive(text_))
      if (const Heard one = hearMessage(text_, told); one != Heard::Nothing) heard = one;
    if (heard == Heard::Missing) break;
  }
  if (heard == Heard::Missing && told.ids.empty())
    return {
        {phrase(TRANSLATE_NOOP("problem",
                               "Haply's service at %1 has no Inverse3. Plug it in, switch it on, and open it again."),
                {place_.text()}),
         {}}};
  if (heard == Heard::Missing)
    return {{phrase(TRANSLATE_NOOP("problem", "Haply's service at %1 has no Inverse3 \"%2\". It has: %3."),
                    {place_.text(), place_.id, namesOf(told.ids)}),
             {}}};
  if (heard != Heard::Place)
    return {{phrase(TRANSLATE_NOOP("problem",
                                   "What answers at %1 does not say where an Inverse3 is. Is it Haply's service?"),
                    {place_.text()}),
             {}}};
  if (told.axes != "XYZ")
    return {
        {phrase(TRANSLATE_NOOP("problem",
                               "Haply's service at %1 tells places in the axes %2. Set the basis of the Inverse3 to "
                               "XYZ there."),
                {place_.text(), told.axes}),
         {}}};
  const std::scoped_lock lock(words_mutex_);
  told_ = std::move(told);
  heard_ = heard;
  was_able_ = true;
  take();
  return {};
}

void HaplyArm::disconnect() {
  ends_ = true;
  wrote_.ring();
  if (thread_.joinable()) thread_.join();
  line_.reset();
}

Problems HaplyArm::reopen() {
  disconnect();
  Problems problems = connect();
  if (!problems.empty()) loss_ = Loss::Line;
  return problems;
}

void HaplyArm::lose(Loss loss) {
  Loss none = Loss::None;
  loss_.compare_exchange_strong(none, loss);
  came_.ring();
}

void HaplyArm::run() {
  system::nameThread("underact-haply");
  system::askForRealTime({}, static_cast<int>(1'000'000'000 / period_ns_));
  while (!ends_ && loss_ == Loss::None) {
    const auto wait_ms = static_cast<int>(std::max<std::int64_t>(kQuietPeriods * period_ns_ / 1'000'000, 1));
    line_->wait(wrote_.descriptor(), wait_ms);
    wrote_.clear();
    hear();
    const std::int64_t now_ns = system::monotonicNow_ns();
    if (!line_->isOpen()) {
      lose(Loss::Line);
    } else if (now_ns - came_ns_ > kSilence_ns) {
      lose(lossOf(heard_));
    } else {
      speak(now_ns);
    }
  }
  // Whatever was lost: zero may still arrive.
  while (line_->isOpen() && line_->isSending() && system::monotonicNow_ns() - sent_ns_ < 100'000'000)
    line_->wait(-1, 1);
  line_->send(forceText(told_.id, form_, Vec3::Zero()));
}

/// All that came; the newest state counts.
void HaplyArm::hear() {
  bool has_place = false;
  while (line_->receive(text_)) {
    unanswered_ = 0;
    const std::scoped_lock lock(words_mutex_);
    const Heard heard = hearMessage(text_, told_);
    if (heard == Heard::Nothing) continue;
    heard_ = heard;
    has_place = heard == Heard::Place;
  }
  if (!has_place) return;
  take();
}

void HaplyArm::take() {
  const Mat3 R_WH = arm::haplyFromWorkspace().transpose();
  Taken& taken = taken_.back();
  taken.number = ++states_;
  taken.came_ns = came_ns_ = system::monotonicNow_ns();
  taken.p_WT = told_.is_middle_origin ? Vec3(R_WH * told_.p_HT) : arm::workspacePlaceFromHaply(told_.p_HT);
  taken.has_grip = told_.R_HT.has_value();
  if (taken.has_grip) taken.R_WT = R_WH * *told_.R_HT;
  taken.buttons = told_.buttons;
  taken.is_able = told_.is_calibrated && told_.has_power && told_.is_ready;
  if (taken.is_able && !was_able_) ++epoch_;  // it may stand elsewhere than it said
  was_able_ = taken.is_able;
  taken.epoch = epoch_;
  taken_.publish();
  came_.ring();
}

/// The tick's last force, once; zero if it is cut, or if the tick wrote nothing for long.
void HaplyArm::speak(std::int64_t now_ns) {
  const Wanted& wanted = wanted_.latest();
  const bool is_new = wanted.number != sent_;
  if (is_new) wrote_ns_ = now_ns;
  const bool is_cut = is_cut_.load(std::memory_order_acquire);
  const std::int64_t quiet_ns = kQuietPeriods * period_ns_;
  const bool is_quiet = now_ns - wrote_ns_ >= quiet_ns && now_ns - sent_ns_ >= quiet_ns;
  if (!is_new && !is_quiet && !is_cut) return;
  const Vec3 f_H = is_new && !is_cut ? wanted.f_H : Vec3::Zero();
  // Late ones would be felt late. What is zero goes out whatever happens.
  if (unanswered_ >= kMaxUnanswered && f_H != Vec3::Zero()) return;
  if (!line_->send(forceText(told_.id, form_, f_H))) return;
  ++unanswered_;
  sent_ = wanted.number;
  sent_ns_ = now_ns;
  if (is_cut) is_cut_.store(false, std::memory_order_release);
}

std::int64_t HaplyArm::staleAfter_ns() const noexcept {
  return std::max(kStale_ns, kStalePeriods * period_ns_.load(std::memory_order_relaxed));
}

bool HaplyArm::read(arm::Sample& sample) noexcept {
  const std::int64_t half_ns = period_ns_.load(std::memory_order_relaxed) / 2;
  const Taken* taken = &taken_.latest();
  if (taken->number == number_) {
    came_.waitFor(half_ns);
    taken = &taken_.latest();
  }
  number_ = taken->number;
  const std::int64_t now_ns = system::monotonicNow_ns();
  if (loss_.load(std::memory_order_acquire) != Loss::None || now_ns - taken->came_ns > staleAfter_ns()) {
    missed_.fetch_add(1, std::memory_order_relaxed);
    pushes_ = false;
    return false;
  }
  missed_.store(0, std::memory_order_relaxed);
  const arm::PositionSolution reach = arm::solvePosition(arm_, taken->p_WT);
  sample.q_rad = taken->has_grip ? arm::solveWrist(reach.q_rad, taken->R_WT) : reach.q_rad;
  pushes_ = reach.reachable && taken->is_able;
  sample.buttons = taken->buttons;
  sample.epoch = taken->epoch;
  // When it came. A tick soon after a late one would divide a distance by almost no time.
  time_ns_ = std::max(now_ns - opened_ns_, time_ns_ + half_ns);
  sample.time_ns = time_ns_;
  return true;
}

void HaplyArm::write(const safety::GatedForce& force) noexcept {
  Wanted& wanted = wanted_.back();
  wanted.number = ++writes_;
  wanted.f_H = pushes_ ? Vec3(arm::haplyFromWorkspace() * force.f_T_W()) : Vec3(Vec3::Zero());
  wanted_.publish();
  is_cut_.store(false, std::memory_order_release);
  wrote_.ring();
}

void HaplyArm::cut() noexcept {
  is_cut_.store(true, std::memory_order_release);
  wrote_.ring();
}

void HaplyArm::setRate(int rate_hz) {
  period_ns_ = periodAt(rate_hz);
}

HaplyArm::Loss HaplyArm::lossOf(Heard heard) {
  return heard == Heard::Missing ? Loss::Arm : heard == Heard::Wrong ? Loss::Words : Loss::Silence;
}

Sentence HaplyArm::wordsOf(Loss loss) const {
  switch (loss) {
    case Loss::Line:
      return phrase(TRANSLATE_NOOP("problem",
                                   "The connection to Haply's service at %1 was lost. Start the service and press "
                                   "Restart."),
                    {place_.text()});
    case Loss::Arm:
      return phrase(
          TRANSLATE_NOOP("problem",
                         "Haply's service at %1 no longer has the Inverse3. Plug it in, switch it on, and press "
                         "Restart."),
          {place_.text()});
    case Loss::Words:
      return phrase(TRANSLATE_NOOP("problem",
                                   "Haply's service at %1 sends messages that are not understood. Restart the service "
                                   "and press Restart."),
                    {place_.text()});
    case Loss::Silence:
      return phrase(TRANSLATE_NOOP("problem",
                                   "Haply's service at %1 no longer says where the Inverse3 is. Check the service and "
                                   "press Restart."),
                    {place_.text()});
    case Loss::None:
      break;
  }
  return {};
}

Sentence HaplyArm::trouble() const {
  if (const Loss loss = loss_; loss != Loss::None) return wordsOf(loss);
  if (missed_ >= kSilentStates) return wordsOf(lossOf(heard_));
  const std::scoped_lock lock(words_mutex_);
  if (!told_.has_power)
    return phrase(TRANSLATE_NOOP("problem", "The Inverse3 has no power supply, so it gives no force. Connect it."));
  if (!told_.is_calibrated)
    return phrase(TRANSLATE_NOOP(
        "problem", "The Inverse3 is not calibrated, so it gives no force. Calibrate it as its manual says."));
  if (!told_.is_ready)
    return phrase(
        TRANSLATE_NOOP("problem", "Haply's service says that the Inverse3 is not ready, so it gives no force."));
  return {};
}

std::vector<std::string> HaplyArm::listing() const {
  const std::scoped_lock lock(words_mutex_);
  std::vector<std::string> lines{"Serial number: " + told_.id,
                                 "Haply's service at " + place_.text() + (form_ == Form::Vector ? ", v3.5" : ", v3.1"),
                                 told_.R_HT ? "with a grip" : "without a grip"};
  if (!told_.type.empty()) lines.push_back(told_.type + ", firmware " + told_.firmware);
  if (told_.angles_deg)
    lines.push_back("its own joints: " + json::numberText(told_.angles_deg->x()) + ", " +
                    json::numberText(told_.angles_deg->y()) + ", " + json::numberText(told_.angles_deg->z()) + " deg");
  return lines;
}

servo::DeviceInfo HaplyArm::info() const {
  const std::scoped_lock lock(words_mutex_);
  return {phrase(TRANSLATE_NOOP("problem", "Inverse3 %1 at %2"), {told_.id, place_.text()}), false, true, kStill_s,
          told_.id};
}

}  // namespace underact::device::haply
