#include "core/base/fault.h"

namespace underact {

std::string describe(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::None:
      return {};
    case FaultKind::NoSample:
      return "The arm stopped answering. Force is off. Check the cable, then press Start.";
    case FaultKind::StaleSample:
      return "The arm sent the same sample twice. Force is off. Check the cable, then press Start.";
    case FaultKind::NotFinite:
      return "The arm sent a position that is not a number. Force is off. Press Start to try again.";
  }
  return {};
}

const char* name(FaultKind kind) {
  switch (kind) {
    case FaultKind::None:
      return "none";
    case FaultKind::NoSample:
      return "no_sample";
    case FaultKind::StaleSample:
      return "stale_sample";
    case FaultKind::NotFinite:
      return "not_finite";
  }
  return "none";
}

}  // namespace underact
