#pragma once
#include <functional>
#include <string>

#include "core/manipulator/manipulator.h"
#include "core/scene/read_parts.h"

namespace underact::scene {

// Internal to the room: what is particular to virtual robots.

/// Four rows of four numbers.
void readPose(const json::Value& value, const std::string& path, Eigen::Matrix4d& into, Findings& findings);

/// Reads joints, home, orientation, solver and force law of an object of the file.
void readManipulator(ObjectReader& object, VirtualManipulator& into);

/// Calls add(key within the constraint, sentence) for each number that is not allowed. True where there was none.
bool checkManipulator(const VirtualManipulator& robot, const Control& control,
                      const std::function<void(const std::string&, Sentence)>& add);

/// The virtual robot in SI. Problems: those between its parts (an angle without a joint for it, ...).
Result<manipulator::Manipulator> makeManipulator(const VirtualManipulator& robot, const Control& control,
                                                 const SourceLocation& place);

}  // namespace underact::scene
