#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "app/cli/json_object.h"
#include "core/base/result.h"
#include "core/lab/step_response.h"

namespace underact::cli {

// The output of `lab step`: as JSON, as a table for people, as the rows of a CSV file.

/// The five keys of the command line; null: not defined.
JsonObject metricsObject(const lab::StepMetrics& metrics);
JsonObject stepObject(const lab::ArmStep& step);

void printStep(const lab::TransferFunction& transfer, const lab::StepMetrics& metrics, std::ostream& out);
void printStep(const lab::ArmStep& step, std::ostream& out);

/// Why numbers are missing or have another meaning than usual, in a sentence; empty: all is as usual.
std::string noteOn(const lab::TransferFunction& transfer);
std::vector<std::string> notesOn(const lab::ArmStep& step);

/// t_s, y; a thousand steps. seconds: 0: as long as it takes to see it.
std::string csvOf(const lab::TransferFunction& transfer, double seconds);
/// t_s, measured_mm, fit_mm, analytic_mm; one row per tick; the fit is empty if there is none.
std::string csvOf(const lab::ArmStep& step);

/// Problems: one, if the file cannot be written.
Problems writeText(const std::string& path, const std::string& text);

}  // namespace underact::cli
