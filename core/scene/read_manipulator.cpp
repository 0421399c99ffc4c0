#include <algorithm>

#include "core/base/translate.h"
#include "core/scene/manipulators.h"
#include "core/scene/rules.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

void readJoint(const json::Value& value, const std::string& path, Joint& into, Findings& findings) {
  if (!isKind(value, json::JsonKind::Object, path,
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"),
                     {"{\"type\": \"revolute\", \"axis\": [0, 0, 1], \"point_mm\": [0, 0, 0]}"}),
              findings)) {
    return;
  }
  findings.remember(path, value);
  ObjectReader joint(value, path, phrase(TRANSLATE_NOOP("problem", "a joint")), findings);
  bool known = false;
  if (const json::Value* type = joint.find("type", true)) {
    known = readWord(*type, joint.pathOf("type"), kJointWords, into.type, findings);
  }
  if (const json::Value* axis = joint.find("axis", true)) {
    readNumber(*axis, joint.pathOf("axis"), into.axis, findings);
  }
  if (into.type == chain::JointType::Revolute) {
    if (const json::Value* point = joint.find("point_mm", known)) {
      readNumber(*point, joint.pathOf("point_mm"), into.point_mm, findings);
    }
  } else {
    joint.refuse("point_mm", phrase(TRANSLATE_NOOP(
                                 "problem", "A prismatic joint has a direction but no point; remove the point.")));
  }
  const bool turns = into.type == chain::JointType::Revolute;
  joint.refuse(stiffnessKey(turns ? chain::JointType::Prismatic : chain::JointType::Revolute),
               phrase(TRANSLATE_NOOP("problem", "The spring of a %1 joint is called \"%2\"."),
                      {wordOf(kJointWords, into.type), stiffnessKey(into.type)}));
  readSettings(joint, into);
  joint.finish(known);
}

}  // namespace

void readPose(const json::Value& value, const std::string& path, Eigen::Matrix4d& into, Findings& findings) {
  findings.remember(path, value);
  const bool four = value.kind == json::JsonKind::Array && value.items.size() == 4;
  if (!four) {
    if (isKind(value, json::JsonKind::Array, path, phrase(TRANSLATE_NOOP("problem", "4 rows of 4 numbers")),
               findings)) {
      findings.add(value, path,
                   phrase(TRANSLATE_NOOP("problem", "A pose has 4 rows of 4 numbers; this one has %1."),
                          {std::to_string(value.items.size())}));
    }
    return;
  }
  for (Eigen::Index row = 0; row < 4; ++row) {
    const json::Value& line = value.items[static_cast<std::size_t>(row)];
    const std::string line_path = path + "[" + std::to_string(row) + "]";
    findings.remember(line_path, line);
    if (!isKind(line, json::JsonKind::Array, line_path, phrase(TRANSLATE_NOOP("problem", "4 numbers")), findings))
      continue;
    if (line.items.size() != 4) {
      findings.add(line, line_path,
                   phrase(TRANSLATE_NOOP("problem", "A row has 4 numbers; this one has %1."),
                          {std::to_string(line.items.size())}));
      continue;
    }
    for (Eigen::Index column = 0; column < 4; ++column) {
      readNumber(line.items[static_cast<std::size_t>(column)], line_path + "[" + std::to_string(column) + "]",
                 into(row, column), findings);
    }
  }
}

void readManipulator(ObjectReader& object, VirtualManipulator& into) {
  Findings& findings = object.findings();
  const json::Value* joints = object.find("joints", true);
  if (joints != nullptr && isKind(*joints, json::JsonKind::Array, object.pathOf("joints"),
                                  phrase(TRANSLATE_NOOP("problem", "a list of joints")), findings)) {
    findings.remember(object.pathOf("joints"), *joints);
    const std::size_t count = joints->items.size();
    if (count > manipulator::kMaxJoints) findings.add(*joints, object.pathOf("joints"), jointCountProblem(count));
    into.joints.resize(std::min(count, manipulator::kMaxJoints));
    for (std::size_t i = 0; i < into.joints.size(); ++i) {
      readJoint(joints->items[i], object.pathOf("joints") + "[" + std::to_string(i) + "]", into.joints[i], findings);
    }
  } else {
    into.joints.emplace_back();  // a harmless one
  }
  if (const json::Value* home = object.find("X_WV_home", true)) {
    readPose(*home, object.pathOf("X_WV_home"), into.X_WV_home, findings);
  }
  readSettings(object, into);
  if (const json::Value* solver = object.find("solver"))
    readObject(*solver, object.pathOf("solver"), phrase(TRANSLATE_NOOP("problem", "a solver")),
               "{\"method\": \"auto\"}", into.solver, findings);
}

}  // namespace underact::scene
