#include "app/gui/window/features.h"

namespace underact::gui {

std::vector<HelpPage> helpPages(const std::vector<FeatureRow>& rows) {
  std::vector<HelpPage> pages{
      {"window", "window"},
      {"view", "window#the-view"},
      {"toolbar", "window#starting-and-stopping"},
      {"button", "window#starting-and-stopping"},
      {"status", "window#the-status-line"},
      {"load", "meshes"},
      {"notice", "window#the-view"},
      {"dialog", "window"},
      {"dialog.newer_settings", "install"},
      {"dialog.not_saved", "window#feel"},
      {"dialog.open", "window#opening-a-file"},
      {"dialog.open_problems", "window#opening-a-file"},
      {"dialog.problems", "scenes"},
      {"dialog.save", "window#feel"},
      {"dialog.unsaved", "window#feel"},
  };
  for (const FeatureRow& row : rows) pages.insert(pages.end(), row.pages.begin(), row.pages.end());
  return pages;
}

}  // namespace underact::gui
