#include "app/gui/feature/feature.h"

namespace underact::gui {

QString openerOf(FileKind kind, const std::vector<FeatureRow>& rows) {
  for (const FeatureRow& row : rows) {
    if (row.open_action != nullptr && row.opens == kind) return row.open_action;
  }
  return {};
}

}  // namespace underact::gui
