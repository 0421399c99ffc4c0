#pragma once
#include <string>

#include "app/bindings/made.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::bindings {

/// A scene as Python has it: as written, with its meshes, and as a tick runs it. Never changed once made.
struct Scene {
  scene::Description description;
  tick::TickProgram program;
};

}  // namespace underact::bindings

template <>
struct pybind11::detail::type_caster<underact::bindings::Scene>
    : underact::bindings::MadeCaster<underact::bindings::Scene> {};
