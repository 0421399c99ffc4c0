#include "app/cli/run_summary.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::cli {
namespace {

JsonObject faultAt(std::int64_t time_ns, const Fault& fault) {
  JsonObject object;
  object.addNumber("time_s", kSecondPerNanosecond * static_cast<double>(time_ns));
  object.addText("kind", name(fault.kind));
  object.addText("sentence", describe(fault));
  object.addText("what", whatHappened(fault));
  object.addText("what_to_do", whatToDo(fault));
  return object;
}

constexpr servo::Percentiles kNoPercentiles{kNotANumber, kNotANumber, kNotANumber, kNotANumber};

}  // namespace

void RunSummary::add(const servo::TickRecord& record) {
  figures_.add(record.error_m, record.f_sent_T_W.norm());
  peak_moment_N_m_ = std::max(peak_moment_N_m_, record.m_sent_T_W.norm());
  if ((record.limits & safety::kClampBit) != 0U) ++clamped_;
  work_.add(record.f_sent_T_W, record.p_WT);
  energy_.add(record.energy_J);
  branch_changes_ += record.branch_changes;
  out_of_reach_ += record.out_of_reach ? 1 : 0;
  if (record.fault != fault_ && record.fault != FaultKind::None) {
    faults_.push_back({record.tick, record.time_ns, Fault{record.fault}});
  }
  fault_ = record.fault;
  lateness_.add(record.lateness_ns);
  tick_time_.add(record.tick_ns);
}

void RunSummary::tell(std::int64_t tick, const Fault& fault) {
  // The row of its kind that began it: of samples that were missing it is the first, and the servo stops later.
  const auto found = std::find_if(faults_.rbegin(), faults_.rend(),
                                  [&](const Found& one) { return one.fault.kind == fault.kind && one.tick <= tick; });
  if (found != faults_.rend()) found->fault = fault;
}

JsonObject RunSummary::json(const Setting& setting) const {
  JsonObject object;
  object.addInteger("ticks", ticks());
  object.addInteger("rate_hz", setting.rate_hz);
  object.addInteger("seed", setting.seed);
  object.addNumber("peak_force_N", figures_.peakForce_N());
  object.addNumber("mean_force_N", figures_.meanForce_N());
  object.addNumber("rms_force_N", figures_.rmsForce_N());
  if (setting.renders_moment) {
    object.addText("moment", *setting.renders_moment ? "rendered" : "not rendered");
    object.addNumber("peak_moment_N_mm", kMillimetrePerMetre * peak_moment_N_m_);
  }
  object.addInteger("clamped_ticks", clamped_);
  object.addNumber("rms_error_mm", kMillimetrePerMetre * figures_.rmsError_m());
  object.addVector("final_p_mm", kMillimetrePerMetre * work_.p_WT());
  object.addNumber("work_mJ", 1e3 * work_.all_J());       // that the force has done on the hand in all
  object.addNumber("most_work_mJ", 1e3 * work_.max_J());  // its maximum during the run
  object.addNumber("energy_mJ", 1e3 * energy_.last_J());  // in the constraints, at the end
  object.addNumber("lowest_energy_mJ", 1e3 * energy_.lowest_J());
  object.addInteger("branch_changes", branch_changes_);
  object.addInteger("out_of_reach_ticks", out_of_reach_);
  std::vector<JsonObject> faults;
  for (const Found& one : faults_) faults.push_back(faultAt(one.time_ns, one.fault));
  object.addList("faults", faults);
  object.addObject("lateness_us", percentilesObject(setting.fast ? kNoPercentiles : lateness_.percentiles()));
  object.addObject("tick_us", percentilesObject(tick_time_.percentiles()));
  object.addText("scheduling", setting.scheduling);
  if (!setting.guard.empty()) object.addText("guard", setting.guard);
  return object;
}

JsonObject percentilesObject(const servo::Percentiles& values) {
  JsonObject object;
  object.addNumber("p50", values.p50_us);
  object.addNumber("p99", values.p99_us);
  object.addNumber("p99.9", values.p999_us);
  object.addNumber("max", values.max_us);
  return object;
}

}  // namespace underact::cli
