#include "app/cli/percentiles_json.h"

namespace underact::cli {

JsonObject percentilesObject(const servo::Percentiles& values) {
  JsonObject object;
  object.addNumber("p50", values.p50_us);
  object.addNumber("p99", values.p99_us);
  object.addNumber("p99.9", values.p999_us);
  object.addNumber("max", values.max_us);
  return object;
}

}  // namespace underact::cli
