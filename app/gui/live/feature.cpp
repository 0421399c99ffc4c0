#include "app/gui/feature/feature.h"

#include "app/gui/live/live_data.h"

namespace underact::gui {
namespace {

void makeLive(const FeatureParts& parts, Followers& followers) {
  followers.push_back(new LiveData(parts));
}

}  // namespace

FeatureRow liveFeature() {
  return {.pages = {{"dialog.live", "sessions"}, {"dialog.address", "window#this-guide"}}, .make = makeLive};
}

}  // namespace underact::gui
