#pragma once
#include <QHash>
#include <vector>

#include "app/gui/window/features.h"

namespace underact::gui {

struct Purpose;

/// The window's docks: one for each panel of its features.
class Docks {
 public:
  Docks(const std::vector<FeatureRow>& rows, const FeatureParts& parts);

  const std::vector<Panel*>& panels() const { return panels_; }
  /// Restores the default layout of a purpose.
  void arrange(const Purpose& purpose);

 private:
  QDockWidget* dock(const char* key) const { return docks_.value(key); }

  QMainWindow* window_;
  std::vector<PanelRow> rows_;
  std::vector<Panel*> panels_;
  QHash<QString, QDockWidget*> docks_;
};

}  // namespace underact::gui
