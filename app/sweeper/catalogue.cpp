#include "app/sweeper/catalogue.h"

#include <algorithm>
#include <vector>

namespace underact::sweep {

std::span<const SweepKind> kinds() {
  static const std::vector<SweepKind> kKinds{handsKind(), stabilityKind()};
  return kKinds;
}

const SweepKind* findKind(std::string_view key) {
  const std::span<const SweepKind> all = kinds();
  const auto found = std::find_if(all.begin(), all.end(), [&](const SweepKind& kind) { return kind.key == key; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace underact::sweep
