#include "core/arm/urdf_tree.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "core/arm/solid_place.h"
#include "core/arm/urdf_words.h"
#include "core/arm/xml_bounds.h"
#include "core/base/translate.h"
#include "core/base/trig.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

using tinyxml2::XMLElement;

constexpr double kFurthest_m = 1e3;
constexpr std::size_t kMaxLinks = 4096;  // a humanoid with two hands has some 100

/// Reads the elements of one file; collects its problems.
class TreeReader : UrdfWords {
 public:
  using UrdfWords::UrdfWords;

  UrdfTree read(const XMLElement& robot) {
    UrdfTree tree;
    checkVersion(robot);
    const char* const name = robot.Attribute("name");
    tree.name = name != nullptr && *name != '\0' ? name : "robot";
    for (const XMLElement* one = robot.FirstChildElement(); one != nullptr; one = one->NextSiblingElement()) {
      const std::string_view what = one->Name();
      if (what.starts_with("xacro:"))
        say(*one, std::string(what),
            phrase(TRANSLATE_NOOP("problem", "This file is a macro (xacro). Expand it into a URDF file first.")));
      if (tree.links.size() > kMaxLinks || tree.joints.size() > kMaxLinks) {
        say(*one, std::string(what),
            phrase(TRANSLATE_NOOP("problem", "A robot can have at most 4096 links and joints.")));
        break;
      }
      if (what == "link") tree.links.push_back(readLink(*one));
      if (what == "joint") tree.joints.push_back(readJoint(*one));
      if (what != "link" && what != "joint") checkWord(*one, {"link", "joint", "material", "transmission", "gazebo"});
    }
    return tree;
  }

  using UrdfWords::take;

 private:
  /// A later version may say by other words how a link moves.
  void checkVersion(const XMLElement& robot) {
    const char* const version = robot.Attribute("version");
    constexpr std::array<std::string_view, 4> kKnown{"1", "1.0", "1.1", "1.2"};
    if (version == nullptr || std::find(kKnown.begin(), kKnown.end(), version) != kKnown.end()) return;
    say(robot, "version",
        phrase(TRANSLATE_NOOP("problem", "This program reads URDF of the versions 1.0, 1.1 and 1.2; here it is %1."),
               {json::shown(version)}));
  }

  std::string named(const XMLElement& element, const char* what, std::unordered_set<std::string>& names) {
    std::string name = attribute(element, "name", what);
    if (!name.empty() && !names.insert(name).second)
      say(element, "name", phrase(TRANSLATE_NOOP("problem", "The name %1 appears twice."), {json::shown(name)}));
    return name;
  }

  /// <origin xyz="" rpy="">: fixed axes, roll about x first; or quat_xyzw="" in place of rpy.
  Pose readOrigin(const XMLElement& parent) {
    Pose X = Pose::Identity();
    const XMLElement* const origin = only(parent, "origin");
    if (origin == nullptr) return X;
    checkAll(*origin, {"xyz", "rpy", "quat_xyzw"});
    Vec3 p = Vec3::Zero(), turn_rad = Vec3::Zero();
    if (three(*origin, "xyz", p) && p.cwiseAbs().maxCoeff() > kFurthest_m)
      say(*origin, "xyz", phrase(TRANSLATE_NOOP("problem", "A length must lie within 1000 m.")));
    X.translation() = p;
    if (const char* const text = origin->Attribute("quat_xyzw")) {
      X.linear() = rotationOf(*origin, text);
      return X;
    }
    three(*origin, "rpy", turn_rad);
    const SinCos r = sinCos(turn_rad.x()), t = sinCos(turn_rad.y()), y = sinCos(turn_rad.z());
    X.linear() << y.cos * t.cos, y.cos * t.sin * r.sin - y.sin * r.cos, y.cos * t.sin * r.cos + y.sin * r.sin,  //
        y.sin * t.cos, y.sin * t.sin * r.sin + y.cos * r.cos, y.sin * t.sin * r.cos - y.cos * r.sin,            //
        -t.sin, t.cos * r.sin, t.cos * r.cos;
    return X;
  }

  /// Of a unit quaternion, which few decimals leave beside 1.
  Mat3 rotationOf(const XMLElement& origin, const char* text) {
    constexpr double kOffUnit = 1e-3;
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    if (origin.Attribute("rpy") != nullptr)
      say(origin, "quat_xyzw",
          phrase(TRANSLATE_NOOP("problem", "An <origin> has either \"rpy\" or \"quat_xyzw\", not both.")));
    if (!numbers(origin, "quat_xyzw", text, {q.coeffs().data(), 4})) return Mat3::Identity();
    if (!(std::abs(q.norm() - 1.0) <= kOffUnit)) {
      say(origin, "quat_xyzw",
          phrase(TRANSLATE_NOOP("problem", "A quaternion must have the length 1; here it is %1."),
                 {json::numberText(q.norm())}));
      return Mat3::Identity();
    }
    return q.normalized().toRotationMatrix();
  }

  /// A length of a form, which has to be above 0.
  double sizeOf(const XMLElement& form, const char* key) {
    if (form.Attribute(key) == nullptr) attribute(form, key, form.Name());
    const double size_m = one(form, key, 1.0);
    if (!(size_m > 0.0 && size_m <= kFurthest_m))
      say(form, key, phrase(TRANSLATE_NOOP("problem", "A length must be above 0 and at most 1000 m.")));
    return size_m;
  }

  /// Its unit is the metre, multiplied by the scale.
  MeshSolid readMesh(const XMLElement& form) {
    checkAttributes(form, {"filename", "scale"});
    MeshSolid mesh;
    mesh.m_per_unit = Vec3::Ones();
    mesh.name = attribute(form, "filename", "mesh");
    mesh.place = {file_, form.GetLineNum(), 0, "filename"};
    if (mesh.name.size() > kLongestMeshName)
      say(form, "filename", phrase(TRANSLATE_NOOP("problem", "The name of the mesh is longer than 1024 bytes.")));
    if (three(form, "scale", mesh.m_per_unit) && !isMeshScale(mesh.m_per_unit))
      say(form, "scale",
          phrase(TRANSLATE_NOOP("problem", "Each factor must be from 1e-9 to 1000, or the same below 0.")));
    return mesh;
  }

  /// A picture; its problems go where into_ points.
  LinkSolid readVisual(const XMLElement& visual, const XMLElement& form) {
    LinkSolid solid;
    const std::string_view what = form.Name();
    if (what == "box") {
      BoxSolid box{Vec3::Constant(1.0)};
      if (form.Attribute("size") == nullptr) attribute(form, "size", "box");
      if (three(form, "size", box.size_m) && !(box.size_m.minCoeff() > 0.0 && box.size_m.maxCoeff() <= kFurthest_m))
        say(form, "size", phrase(TRANSLATE_NOOP("problem", "A length must be above 0 and at most 1000 m.")));
      solid.form = box;
    } else if (what == "cylinder") {
      solid.form = CylinderSolid{sizeOf(form, "radius"), sizeOf(form, "length")};
    } else if (what == "capsule") {
      solid.form = CapsuleSolid{sizeOf(form, "radius"), sizeOf(form, "length")};
    } else if (what == "sphere") {
      solid.form = SphereSolid{sizeOf(form, "radius")};
    } else if (what == "mesh") {
      solid.form = readMesh(form);
    } else {
      say(form, json::plainKey(form.Name()),
          phrase(TRANSLATE_NOOP("problem", "The form %1 is not known here."), {json::shown(form.Name())}));
    }
    solid.X_WS = readOrigin(visual);
    return solid;
  }

  /// A picture that cannot be drawn is left out, with a note: it moves nothing.
  void readVisuals(const XMLElement& element, UrdfLink& link) {
    Problems* const problems = std::exchange(into_, &link.notes);
    for (const XMLElement* visual = element.FirstChildElement("visual"); visual != nullptr;
         visual = visual->NextSiblingElement("visual")) {
      const XMLElement* const geometry = visual->FirstChildElement("geometry");
      const XMLElement* const form = geometry == nullptr ? nullptr : geometry->FirstChildElement();
      if (form == nullptr) continue;
      const std::size_t before = link.notes.size();
      LinkSolid solid = readVisual(*visual, *form);
      if (link.notes.size() == before) link.solids.push_back(std::move(solid));
    }
    for (Problem& note : link.notes)
      note.sentence = phrase(TRANSLATE_NOOP("problem", "A picture of link %1 is not drawn: %2"),
                             {json::shown(link.name), note.sentence});
    into_ = problems;
  }

  UrdfLink readLink(const XMLElement& element) {
    UrdfLink link{named(element, "link", links_), element.GetLineNum(), {}, {}, {}};
    const XMLElement* const inertial = element.FirstChildElement("inertial");
    for (const XMLElement* one = element.FirstChildElement(); one != nullptr; one = one->NextSiblingElement())
      checkWord(*one, {"inertial", "visual", "collision"});
    readVisuals(element, link);
    if (inertial == nullptr) return link;
    for (const XMLElement* one = inertial->FirstChildElement(); one != nullptr; one = one->NextSiblingElement())
      checkWord(*one, {"origin", "mass", "inertia"});
    const Pose X = readOrigin(*inertial);
    LinkMass mass;
    mass.p_WC = X.translation();
    if (const XMLElement* const mass_element = inertial->FirstChildElement("mass")) {
      mass.mass_kg = one(*mass_element, "value", 0.0);
      if (!(mass.mass_kg >= 0.0))
        say(*mass_element, "value", phrase(TRANSLATE_NOOP("problem", "This must be 0 or above.")));
    }
    if (const XMLElement* const inertia = inertial->FirstChildElement("inertia")) {
      Mat3 I;
      const double xy = one(*inertia, "ixy", 0.0), xz = one(*inertia, "ixz", 0.0), yz = one(*inertia, "iyz", 0.0);
      I << one(*inertia, "ixx", 0.0), xy, xz, xy, one(*inertia, "iyy", 0.0), yz, xz, yz, one(*inertia, "izz", 0.0);
      mass.inertia_W_kg_m2 = X.linear() * I * X.linear().transpose();
    }
    link.mass = mass;
    return link;
  }

  std::string linkOf(const XMLElement& joint, const char* end) {
    const XMLElement* const element = only(joint, end);
    if (element != nullptr) return attribute(*element, "link", end);
    say(joint, end, phrase(TRANSLATE_NOOP("problem", "The element <%1> is missing; <joint> needs it."), {end}));
    return {};
  }

  void readLimits(const XMLElement& element, UrdfJoint& joint) {
    const XMLElement* const limit = only(element, "limit");
    if (limit == nullptr) {
      if (joint.type == "continuous") return;
      return say(element, "limit",
                 phrase(TRANSLATE_NOOP("problem", "The element <%1> is missing; <joint> needs it."), {"limit"}));
    }
    checkAttributes(*limit, {"lower", "upper", "effort", "velocity"});
    if (joint.type == "continuous") return;
    joint.min = one(*limit, "lower", 0.0);
    joint.max = one(*limit, "upper", 0.0);
    joint.limit_line = limit->GetLineNum();
    joint.lacks_limits = joint.min == 0.0 && joint.max == 0.0;
    if (joint.lacks_limits) joint.min = -kInfinity, joint.max = kInfinity;
  }

  UrdfJoint readJoint(const XMLElement& element) {
    UrdfJoint joint;
    joint.line = element.GetLineNum();
    joint.name = named(element, "joint", joints_);
    joint.type = attribute(element, "type", "joint");
    for (const XMLElement* one = element.FirstChildElement(); one != nullptr; one = one->NextSiblingElement())
      checkWord(*one, {"origin", "parent", "child", "axis", "calibration", "dynamics", "limit", "mimic",
                       "safety_controller"});
    const std::vector<std::string> types{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
    if (joint.type == "revolute" || joint.type == "continuous") joint.motion = UrdfMotion::Turns;
    if (joint.type == "prismatic") joint.motion = UrdfMotion::Slides;
    if (joint.type == "floating" || joint.type == "planar") joint.motion = UrdfMotion::Other;
    if (!joint.type.empty() && std::find(types.begin(), types.end(), joint.type) == types.end()) {
      const std::string nearest = json::nearestWord(joint.type, types);
      say(element, "type",
          nearest.empty() ? phrase(TRANSLATE_NOOP("problem", "A joint's type must be %1; here it is %2."),
                                   {json::listed(types), json::shown(joint.type)})
                          : phrase(TRANSLATE_NOOP("problem", "The type %1 is not known. Did you mean \"%2\"?"),
                                   {json::shown(joint.type), nearest}));
    }
    joint.parent = linkOf(element, "parent");
    joint.child = linkOf(element, "child");
    joint.X_ParentJoint = readOrigin(element);
    joint.follows = element.FirstChildElement("mimic") != nullptr;
    if (joint.motion == UrdfMotion::Turns || joint.motion == UrdfMotion::Slides) {
      if (const XMLElement* const axis = only(element, "axis")) {
        checkAll(*axis, {"xyz"});
        const bool read = three(*axis, "xyz", joint.axis);
        const double length = joint.axis.stableNorm();
        if (read && !(length > 0.0 && std::isfinite(length)))
          say(*axis, "xyz", phrase(TRANSLATE_NOOP("problem", "The axis has no direction.")));
        if (length > 0.0 && std::isfinite(length)) joint.axis /= length;
      }
      readLimits(element, joint);
    }
    return joint;
  }

  std::unordered_set<std::string> links_, joints_;
};

/// What tinyxml2 says, in plain words.
Sentence stopOf(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return phrase(TRANSLATE_NOOP("problem", "The file is empty."));
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return phrase(TRANSLATE_NOOP("problem", "An element is not closed, or closed by another name, here or above."));
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return phrase(TRANSLATE_NOOP("problem", "An attribute of this element is not written as name=\"value\"."));
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return phrase(TRANSLATE_NOOP("problem", "The elements are nested more than 100 levels deep."));
    default:
      return phrase(TRANSLATE_NOOP("problem", "Here the text stops being XML."));
  }
}

}  // namespace

Result<UrdfTree> readUrdfTree(std::string_view text, const std::string& file_name) {
  if (text.find('\0') != std::string_view::npos)
    return Problems{
        problemAt(file_name, 0, "", phrase(TRANSLATE_NOOP("problem", "This is no text: it contains zero bytes.")))};
  if (const std::optional<XmlExcess> excess = excessOf(text))
    return Problems{problemAt(file_name, excess->line, "", excess->sentence)};
  tinyxml2::XMLDocument document;
  if (const tinyxml2::XMLError error = document.Parse(text.data(), text.size()); error != tinyxml2::XML_SUCCESS)
    return Problems{problemAt(file_name, document.ErrorLineNum(), "", stopOf(error))};
  for (const tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToUnknown() == nullptr) continue;
    return Problems{problemAt(file_name, node->GetLineNum(), "",
                              phrase(TRANSLATE_NOOP("problem", "A document type is not allowed here. Remove it.")))};
  }
  const XMLElement* const robot = document.RootElement();
  if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
    return Problems{problemAt(file_name, robot == nullptr ? 0 : robot->GetLineNum(), "",
                              phrase(TRANSLATE_NOOP("problem", "A URDF file is one element <robot>.")))};
  }
  TreeReader reader(file_name);
  UrdfTree tree = reader.read(*robot);
  Problems problems = reader.take();
  if (!problems.empty()) return problems;
  return tree;
}

}  // namespace underact::arm
