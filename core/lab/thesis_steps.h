#pragma once
#include <span>
#include <vector>

#include "core/lab/transfer_function.h"

namespace underact::lab {

/// A figure of the thesis's appendix B: one step response, or several beside each other.
struct ThesisStep {
  /// One curve of a figure: its name, and the transfer function whose unit step it is.
  struct Response {
    const char* name;
    TransferFunction transfer;
  };
  const char* key;                  // "B.1"
  const char* title;                // as the thesis has it
  const char* what;                 // one sentence
  double seconds;                   // of the figure
  std::vector<Response> responses;  // the first is the one that is measured
};

/// Figures B.1 to B.5; B.3 with the signs corrected by errata section 8.
std::span<const ThesisStep> thesisSteps();

}  // namespace underact::lab
