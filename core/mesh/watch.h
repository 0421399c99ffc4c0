#pragma once
#include "core/base/watch.h"

namespace underact::mesh {

using underact::Watch;

}  // namespace underact::mesh
