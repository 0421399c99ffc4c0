#pragma once
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "core/arm/sample.h"
#include "core/base/types.h"
#include "core/base/units.h"
#include "core/json/json.h"

namespace underact::test {

using json::Value;

/// A file of tests/golden; an empty value, and a failure, where it cannot be read.
inline Value golden(const std::string& name) {
  std::ifstream file(std::string(UNDERACT_TEST_DATA) + "/golden/" + name);
  std::stringstream text;
  text << file.rdbuf();
  Result<Value> root = json::parse(text.str(), name);
  if (!root) {
    ADD_FAILURE() << describe(root.problems().front());
    return {};
  }
  return std::move(root).value();
}

inline arm::JointAngles anglesOf(const Value& list) {
  arm::JointAngles q_rad{};
  for (std::size_t joint = 0; joint < 6; ++joint) q_rad[joint] = list.items.at(joint).number;
  return q_rad;
}

/// A pose of a file, whose lengths are mm.
inline Pose poseOf(const Value& rows) {
  Pose X_WT = Pose::Identity();
  for (Eigen::Index row = 0; row < 3; ++row) {
    const Value& numbers = rows.items.at(static_cast<std::size_t>(row));
    for (Eigen::Index column = 0; column < 3; ++column) {
      X_WT.linear()(row, column) = numbers.items.at(static_cast<std::size_t>(column)).number;
    }
    X_WT.translation()[row] = kMetrePerMillimetre * numbers.items.at(3).number;
  }
  return X_WT;
}

}  // namespace underact::test
