#include "core/arm/urdf_tree.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_set>

#include "core/arm/solid_place.h"
#include "core/arm/xml_bounds.h"
#include "core/base/translate.h"
#include "core/base/trig.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

using tinyxml2::XMLElement;

constexpr double kFurthest_m = 1e3;
constexpr std::size_t kMostUrdfProblems = 100;
constexpr std::size_t kMostLinks = 4096;  // a humanoid with two hands has some 100

Problem problemAt(const std::string& file, int line, const std::string& key, Sentence sentence) {
  return {std::move(sentence), {file, line, 0, key}};
}

/// Reads the elements of one file; collects its problems.
class TreeReader {
 public:
  explicit TreeReader(const std::string& file) : file_(file) {}

  UrdfTree read(const XMLElement& robot) {
    UrdfTree tree;
    tree.name = attribute(robot, "name", "robot");
    for (const XMLElement* one = robot.FirstChildElement(); one != nullptr; one = one->NextSiblingElement()) {
      const std::string_view what = one->Name();
      if (what.starts_with("xacro:"))
        say(*one, std::string(what),
            said(TRANSLATE_NOOP("problem", "This file is a macro (xacro). Expand it into a URDF file first.")));
      if (tree.links.size() > kMostLinks || tree.joints.size() > kMostLinks) {
        say(*one, std::string(what),
            said(TRANSLATE_NOOP("problem", "A robot can have at most 4096 links and joints.")));
        break;
      }
      if (what == "link") tree.links.push_back(readLink(*one));
      if (what == "joint") tree.joints.push_back(readJoint(*one));
      if (what != "link" && what != "joint") checkWord(*one, {"link", "joint", "material", "transmission", "gazebo"});
    }
    return tree;
  }

  Problems take() { return std::move(problems_); }

 private:
  void say(const XMLElement& at, const std::string& key, Sentence sentence) {
    if (problems_.size() < kMostUrdfProblems)
      problems_.push_back(problemAt(file_, at.GetLineNum(), key, std::move(sentence)));
  }

  /// A word that is nearly a known one is a typing error; another one belongs to another program.
  void checkWord(const XMLElement& element, const std::vector<std::string>& known) {
    if (problems_.size() >= kMostUrdfProblems) return;
    const std::string word = element.Name(), nearest = json::nearestWord(word, known);
    if (nearest.empty() || nearest == word) return;
    say(element, json::plainKey(word),
        said(TRANSLATE_NOOP("problem", "The element %1 is not known here. Did you mean \"%2\"?"),
             {json::shown(word), nearest}));
  }
  void checkAttributes(const XMLElement& element, const std::vector<std::string>& known) {
    for (const tinyxml2::XMLAttribute* one = element.FirstAttribute(); one != nullptr; one = one->Next()) {
      const std::string word = one->Name(), nearest = json::nearestWord(word, known);
      if (nearest.empty() || nearest == word || problems_.size() >= kMostUrdfProblems) continue;
      problems_.push_back(
          problemAt(file_, one->GetLineNum(), json::plainKey(word),
                    said(TRANSLATE_NOOP("problem", "The attribute %1 is not known in <%2>. Did you mean \"%3\"?"),
                         {json::shown(word), std::string(element.Name()), nearest})));
    }
  }

  std::string attribute(const XMLElement& element, const char* key, const char* what) {
    const char* const text = element.Attribute(key);
    if (text != nullptr && *text != '\0') return text;
    say(element, key,
        said(TRANSLATE_NOOP("problem", "The attribute \"%1\" is missing; %2 needs it."),
             {key, "<" + std::string(what) + ">"}));
    return {};
  }

  std::string named(const XMLElement& element, const char* what, std::unordered_set<std::string>& names) {
    std::string name = attribute(element, "name", what);
    if (!name.empty() && !names.insert(name).second)
      say(element, "name", said(TRANSLATE_NOOP("problem", "The name %1 appears twice."), {json::shown(name)}));
    return name;
  }

  /// Numbers separated by white space, as many as there have to be.
  bool numbers(const XMLElement& element, const char* key, const char* text, std::span<double> into) {
    std::string_view rest = text;
    std::vector<double> read;
    const auto skip = [&] {
      while (!rest.empty() && std::string_view(" \t\r\n").find(rest.front()) != std::string_view::npos)
        rest.remove_prefix(1);
    };
    for (skip(); !rest.empty() && read.size() <= into.size(); skip()) {
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
      std::string_view word = rest.substr(0, end);
      rest.remove_prefix(end);
      if (word.starts_with('+')) word.remove_prefix(1);
      const std::optional<double> number = json::wholeNumber(word);
      if (!number) break;
      read.push_back(*number);
    }
    if (read.size() == into.size() && rest.empty()) {
      std::copy(read.begin(), read.end(), into.begin());
      return true;
    }
    const std::string count = std::to_string(into.size());
    say(element, key,
        into.size() == 1
            ? said(TRANSLATE_NOOP("problem", "This must be a finite number; here it is %1."), {json::shown(text)})
            : said(TRANSLATE_NOOP("problem", "This must be %1 finite numbers; here it is %2."),
                   {count, json::shown(text)}));
    return false;
  }

  bool three(const XMLElement& element, const char* key, Vec3& into) {
    const char* const text = element.Attribute(key);
    return text == nullptr || numbers(element, key, text, {into.data(), 3});
  }

  double one(const XMLElement& element, const char* key, double otherwise) {
    double number = otherwise;
    if (const char* const text = element.Attribute(key)) numbers(element, key, text, {&number, 1});
    return number;
  }

  /// <origin xyz="" rpy="">: fixed axes, roll about x first.
  Pose readOrigin(const XMLElement& parent) {
    Pose X = Pose::Identity();
    const XMLElement* const origin = parent.FirstChildElement("origin");
    if (origin == nullptr) return X;
    checkAttributes(*origin, {"xyz", "rpy"});
    Vec3 p = Vec3::Zero(), turn_rad = Vec3::Zero();
    if (three(*origin, "xyz", p) && p.cwiseAbs().maxCoeff() > kFurthest_m)
      say(*origin, "xyz", said(TRANSLATE_NOOP("problem", "A length must lie within 1000 m.")));
    three(*origin, "rpy", turn_rad);
    const SinCos r = sinCos(turn_rad.x()), t = sinCos(turn_rad.y()), y = sinCos(turn_rad.z());
    X.linear() << y.cos * t.cos, y.cos * t.sin * r.sin - y.sin * r.cos, y.cos * t.sin * r.cos + y.sin * r.sin,  //
        y.sin * t.cos, y.sin * t.sin * r.sin + y.cos * r.cos, y.sin * t.sin * r.cos - y.cos * r.sin,            //
        -t.sin, t.cos * r.sin, t.cos * r.cos;
    X.translation() = p;
    return X;
  }

  /// A length of a form, which has to be above 0.
  double sizeOf(const XMLElement& form, const char* key) {
    if (form.Attribute(key) == nullptr) attribute(form, key, form.Name());
    const double size_m = one(form, key, 1.0);
    if (!(size_m > 0.0 && size_m <= kFurthest_m))
      say(form, key, said(TRANSLATE_NOOP("problem", "A length must be above 0 and at most 1000 m.")));
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
      say(form, "filename", said(TRANSLATE_NOOP("problem", "The name of the mesh is longer than 1024 bytes.")));
    if (three(form, "scale", mesh.m_per_unit) && !isMeshScale(mesh.m_per_unit))
      say(form, "scale",
          said(TRANSLATE_NOOP("problem", "Each factor must be from 1e-9 to 1000, or the same below 0.")));
    return mesh;
  }

  void readVisuals(const XMLElement& element, UrdfLink& link) {
    for (const XMLElement* visual = element.FirstChildElement("visual"); visual != nullptr;
         visual = visual->NextSiblingElement("visual")) {
      const XMLElement* const geometry = visual->FirstChildElement("geometry");
      const XMLElement* const form = geometry == nullptr ? nullptr : geometry->FirstChildElement();
      if (form == nullptr) continue;
      LinkSolid solid;
      const std::string_view what = form->Name();
      if (what == "box") {
        BoxSolid box{Vec3::Constant(1.0)};
        if (form->Attribute("size") == nullptr) attribute(*form, "size", "box");
        if (three(*form, "size", box.size_m) && !(box.size_m.minCoeff() > 0.0 && box.size_m.maxCoeff() <= kFurthest_m))
          say(*form, "size", said(TRANSLATE_NOOP("problem", "A length must be above 0 and at most 1000 m.")));
        solid.form = box;
      } else if (what == "cylinder") {
        solid.form = CylinderSolid{sizeOf(*form, "radius"), sizeOf(*form, "length")};
      } else if (what == "sphere") {
        solid.form = SphereSolid{sizeOf(*form, "radius")};
      } else if (what == "mesh") {
        solid.form = readMesh(*form);
      } else {
        link.has_other_form = true;
        continue;
      }
      solid.X_WS = readOrigin(*visual);
      link.solids.push_back(solid);
    }
  }

  UrdfLink readLink(const XMLElement& element) {
    UrdfLink link{named(element, "link", links_), element.GetLineNum(), {}, {}, false};
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
    if (const XMLElement* const said_mass = inertial->FirstChildElement("mass")) {
      mass.mass_kg = one(*said_mass, "value", 0.0);
      if (!(mass.mass_kg >= 0.0)) say(*said_mass, "value", said(TRANSLATE_NOOP("problem", "This must be 0 or above.")));
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
    const XMLElement* const element = joint.FirstChildElement(end);
    if (element != nullptr) return attribute(*element, "link", end);
    say(joint, end, said(TRANSLATE_NOOP("problem", "The element <%1> is missing; <joint> needs it."), {end}));
    return {};
  }

  void readLimits(const XMLElement& element, UrdfJoint& joint) {
    const XMLElement* const limit = element.FirstChildElement("limit");
    if (limit == nullptr) {
      if (joint.type == "continuous") return;
      return say(element, "limit",
                 said(TRANSLATE_NOOP("problem", "The element <%1> is missing; <joint> needs it."), {"limit"}));
    }
    checkAttributes(*limit, {"lower", "upper", "effort", "velocity"});
    if (joint.type == "continuous") return;
    joint.min = one(*limit, "lower", 0.0);
    joint.max = one(*limit, "upper", 0.0);
    joint.limit_line = limit->GetLineNum();
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
          nearest.empty() ? said(TRANSLATE_NOOP("problem", "A joint's type must be %1; here it is %2."),
                                 {json::listed(types), json::shown(joint.type)})
                          : said(TRANSLATE_NOOP("problem", "The type %1 is not known. Did you mean \"%2\"?"),
                                 {json::shown(joint.type), nearest}));
    }
    joint.parent = linkOf(element, "parent");
    joint.child = linkOf(element, "child");
    joint.X_ParentJoint = readOrigin(element);
    joint.follows = element.FirstChildElement("mimic") != nullptr;
    if (joint.motion == UrdfMotion::Turns || joint.motion == UrdfMotion::Slides) {
      if (const XMLElement* const axis = element.FirstChildElement("axis")) {
        checkAttributes(*axis, {"xyz"});
        const bool read = three(*axis, "xyz", joint.axis);
        const double length = joint.axis.stableNorm();
        if (read && !(length > 0.0 && std::isfinite(length)))
          say(*axis, "xyz", said(TRANSLATE_NOOP("problem", "The axis has no direction.")));
        if (length > 0.0 && std::isfinite(length)) joint.axis /= length;
      }
      readLimits(element, joint);
    }
    return joint;
  }

  std::string file_;
  Problems problems_;
  std::unordered_set<std::string> links_, joints_;
};

/// What tinyxml2 says, in plain words.
Sentence stopOf(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return said(TRANSLATE_NOOP("problem", "The file is empty."));
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return said(TRANSLATE_NOOP("problem", "An element is not closed, or closed by another name, here or above."));
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return said(TRANSLATE_NOOP("problem", "An attribute of this element is not written as name=\"value\"."));
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return said(TRANSLATE_NOOP("problem", "The elements are nested more than 100 levels deep."));
    default:
      return said(TRANSLATE_NOOP("problem", "Here the text stops being XML."));
  }
}

}  // namespace

Result<UrdfTree> readUrdfTree(std::string_view text, const std::string& file_name) {
  if (text.find('\0') != std::string_view::npos)
    return Problems{
        problemAt(file_name, 0, "", said(TRANSLATE_NOOP("problem", "This is no text: it contains zero bytes.")))};
  if (const std::optional<XmlExcess> excess = excessOf(text))
    return Problems{problemAt(file_name, excess->line, "", excess->sentence)};
  tinyxml2::XMLDocument document;
  if (const tinyxml2::XMLError error = document.Parse(text.data(), text.size()); error != tinyxml2::XML_SUCCESS)
    return Problems{problemAt(file_name, document.ErrorLineNum(), "", stopOf(error))};
  for (const tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToUnknown() == nullptr) continue;
    return Problems{problemAt(file_name, node->GetLineNum(), "",
                              said(TRANSLATE_NOOP("problem", "A document type is not allowed here. Remove it.")))};
  }
  const XMLElement* const robot = document.RootElement();
  if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
    return Problems{problemAt(file_name, robot == nullptr ? 0 : robot->GetLineNum(), "",
                              said(TRANSLATE_NOOP("problem", "A URDF file is one element <robot>.")))};
  }
  TreeReader reader(file_name);
  UrdfTree tree = reader.read(*robot);
  Problems problems = reader.take();
  if (!problems.empty()) return problems;
  return tree;
}

}  // namespace underact::arm
