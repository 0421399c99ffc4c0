#include "app/cli/run_summary.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::cli {
namespace {

JsonObject faultAt(const servo::TickRecord& record) {
  JsonObject object;
  object.addNumber("time_s", kSecondPerNanosecond * static_cast<double>(record.time_ns));
  object.addText("kind", name(record.fault));
  object.addText("sentence", describe(Fault{record.fault}));
  return object;
}

JsonObject percentiles(const servo::Percentiles& values) {
  JsonObject object;
  object.addNumber("p50", values.p50_us);
  object.addNumber("p99", values.p99_us);
  object.addNumber("p99.9", values.p999_us);
  object.addNumber("max", values.max_us);
  return object;
}

constexpr servo::Percentiles kNoPercentiles{kNotANumber, kNotANumber, kNotANumber, kNotANumber};

}  // namespace

void RunSummary::add(const servo::TickRecord& record) {
  ++ticks_;
  const double force_N = record.f_sent_T_W.norm();
  peak_force_N_ = std::max(peak_force_N_, force_N);
  sum_force_N_ += force_N;
  sum_square_error_m2_ += record.error_m * record.error_m;
  if (record.cut_N > 0.0) ++clamped_;
  p_WT_ = record.p_WT;
  if (record.fault != fault_ && record.fault != FaultKind::None) faults_.push_back(faultAt(record));
  fault_ = record.fault;
  lateness_.add(record.lateness_ns);
  tick_time_.add(record.tick_ns);
}

JsonObject RunSummary::json(const Setting& setting) const {
  const double count = static_cast<double>(ticks_);
  JsonObject object;
  object.addInteger("ticks", ticks_);
  object.addInteger("rate_hz", setting.rate_hz);
  object.addInteger("seed", setting.seed);
  object.addNumber("peak_force_N", peak_force_N_);
  object.addNumber("mean_force_N", sum_force_N_ / count);
  object.addInteger("clamped_ticks", clamped_);
  object.addNumber("rms_error_mm", kMillimetrePerMetre * std::sqrt(sum_square_error_m2_ / count));
  object.addVector("final_p_mm", kMillimetrePerMetre * p_WT_);
  object.addList("faults", faults_);
  object.addObject("lateness_us", percentiles(setting.fast ? kNoPercentiles : lateness_.percentiles()));
  object.addObject("tick_us", percentiles(tick_time_.percentiles()));
  object.addText("scheduling", setting.scheduling);
  return object;
}

}  // namespace underact::cli
