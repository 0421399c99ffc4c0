#pragma once
#include <pybind11/pybind11.h>

namespace underact::bindings {

/// underact._core: what each part of the package calls.
void addArm(pybind11::module_& core);
void addScene(pybind11::module_& core);
void addSim(pybind11::module_& core);

}  // namespace underact::bindings
