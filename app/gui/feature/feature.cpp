#include "app/gui/feature/feature.h"

namespace underact::gui {

QString openerOf(const QString& path, const std::vector<FeatureRow>& rows) {
  for (const FeatureRow& row : rows) {
    if (row.opens != nullptr && row.opens(path)) return row.open_action;
  }
  return {};
}

}  // namespace underact::gui
