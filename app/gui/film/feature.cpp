#include "app/gui/feature/feature.h"

#include "app/gui/film/film_tool.h"

namespace underact::gui {
namespace {

void makeFilmTool(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new FilmTool(parts));
}

}  // namespace

FeatureRow filmFeature() {
  return {.pages = {{"dialog.film", "window#films"},
                    {"dialog.filming", "window#films"},
                    {"dialog.film_problems", "window#films"}},
          .make = makeFilmTool};
}

}  // namespace underact::gui
