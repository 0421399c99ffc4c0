#include "app/gui/feature/feature.h"

#include "app/gui/guide/guide_tool.h"

namespace underact::gui {
namespace {

void makeGuide(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new GuideTool(parts.actions, parts.pages, parts.settings, parts.window));
}

}  // namespace

FeatureRow guideFeature() {
  return {.pages = {{"guide", "window#this-guide"},
                    {"button.help.guide", "window#this-guide"},
                    {"dialog.guide_problems", "install"},
                    {"dialog.guide_print", "window#this-guide"},
                    {"dialog.guide_pdf", "window#this-guide"},
                    {"dialog.guide_pdf_problems", "window#this-guide"},
                    {"dialog.notebook", "python#notebooks"},
                    {"dialog.notebook_problems", "python#notebooks"}},
          .make = makeGuide,
          .opens = FileKind::Notebook,
          .open_action = "notebook.open"};
}

}  // namespace underact::gui
