#include "core/target/target.h"

namespace underact::target {

const char* name(Status status) {
  switch (status) {
    case Status::Unique:
      return "unique";
    case Status::Degenerate:
      return "degenerate";
    case Status::Free:
      return "free";
  }
  return "degenerate";
}

}  // namespace underact::target
