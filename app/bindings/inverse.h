#pragma once
#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>

#include "app/bindings/made.h"
#include "core/kinematics/solved_arm.h"

template <>
struct pybind11::detail::type_caster<underact::kinematics::SolvedArm>
    : underact::bindings::MadeCaster<underact::kinematics::SolvedArm> {};

namespace underact::bindings {

/// All solutions for each pose of X, as arrays of one shape: q (not a number beyond those that there are), count,
/// reachable, singular, within_limits, branch, family; then the names of the branches and of the families, and the
/// largest count. search: as
/// kinematics::InverseOptions. prefer: None, or joint values.
pybind11::tuple inverse(const kinematics::SolvedArm& arm, const pybind11::handle& X, const std::string& method,
                        std::uint64_t seed, int search, const pybind11::handle& prefer);

}  // namespace underact::bindings
