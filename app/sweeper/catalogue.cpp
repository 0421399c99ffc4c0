#include "app/sweeper/catalogue.h"

#include <algorithm>
#include <vector>

namespace underact::sweep {

std::span<const Kind> kinds() {
  static const std::vector<Kind> kKinds{handsKind(), stabilityKind()};
  return kKinds;
}

const Kind* findKind(std::string_view key) {
  const std::span<const Kind> all = kinds();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Kind& kind) { return kind.key == key; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace underact::sweep
