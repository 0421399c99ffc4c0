#pragma once
#include <string>
#include <vector>

#include "core/record/session.h"

namespace underact::record {

/// One thing in which two sessions differ, each side as JSON has it; empty: that session does not say it.
struct SessionDifference {
  std::string what;  // a path: "servo.rate_hz", "scene.constraints[rim].radius_mm", "ticks.q_rad"
  std::string a, b;
};

/// Everything in which what was run differs: provenance, scenes, settings of the servo, who took part and what they
/// agreed to, and the ticks by the first one that differs. Not: file, name, notes and tags, when it was recorded, and
/// what was measured of the machine's time. Cost: linear in the ticks. Problems: one of the files cannot be read.
Result<std::vector<SessionDifference>> differencesBetween(Session& a, Session& b);

}  // namespace underact::record
