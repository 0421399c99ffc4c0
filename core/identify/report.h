#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/identify/identified.h"
#include "core/sim/arm_model_file.h"

namespace underact::identify {

/// The true values of a simulated arm, to compare the results with.
struct Given {
  sim::ArmModel model;
  arm::EncoderCounts counts_per_turn{};  // that it counts with
};

/// A line of the results.
struct ReportRow {
  Sentence quantity;
  std::string unit;
  Estimate estimate;
  std::optional<double> given = {};  // by a simulation, or asked of the servo
  int max_digits = 4;                // behind the point, at most: more are not significant
};

/// All results in the order in which they are shown. given: null where the true values are unknown, as of a real arm.
std::vector<ReportRow> rowsOf(const Identified& found, const Given* given);

/// "45.01", with as many digits as the uncertainty allows, or "below 0.02".
Sentence valueText(const ReportRow& row);
/// One standard deviation, two digits; or that it is below the digits shown.
Sentence uncertaintyText(const ReportRow& row);
/// The relative difference from the given value, "+0.3 %"; empty where nothing was given, or 0.
Sentence differenceText(const ReportRow& row);

/// The model with the results; a quantity that is not distinguished from zero is 0 in it.
sim::ArmModelFile modelFileOf(const Identified& found, const std::string& name, const std::string& title,
                              sim::Provenance provenance);

/// The method in a sentence, for the provenance.
std::string methodSentence();

/// The report, Markdown.
std::string reportText(const Identified& found, const sim::ArmModelFile& file, const Given* given);

}  // namespace underact::identify
