#pragma once
#include "core/lesson/layers.h"

namespace underact::gui {

using lesson::Layers;

}  // namespace underact::gui
