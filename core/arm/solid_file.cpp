#include "core/arm/solid_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>

#include "core/arm/arm_text.h"
#include "core/arm/file_values.h"
#include "core/arm/solid_place.h"
#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

using json::Findings;
using json::ObjectReader;
using json::Value;

enum class SolidKind { Box, Cylinder, Capsule, Sphere, Mesh };
constexpr json::Word<SolidKind> kSolidKinds[] = {{"box", SolidKind::Box},
                                                 {"cylinder", SolidKind::Cylinder},
                                                 {"capsule", SolidKind::Capsule},
                                                 {"sphere", SolidKind::Sphere},
                                                 {"mesh", SolidKind::Mesh}};

/// A length above 0, m.
double sizeAt(ObjectReader& object, const char* key) {
  const double size_m = lengthAt(object, key);
  const Value* const value = object.find(key);
  if (value != nullptr && !(size_m > 0.0))
    object.findings().add(*value, object.pathOf(key), phrase(TRANSLATE_NOOP("problem", "This must be above 0.")));
  return size_m;
}

MeshSolid readMeshSolid(ObjectReader& object) {
  MeshSolid mesh;
  Findings& findings = object.findings();
  const std::string path = object.pathOf("file");
  if (const Value* const file = object.find("file", true)) {
    json::readText(*file, path, mesh.name, findings);
    mesh.place = {findings.file(), file->line, file->column, path};
    if (file->kind == json::JsonKind::String && mesh.name.empty())
      findings.add(*file, path, phrase(TRANSLATE_NOOP("problem", "This must be the name of a mesh file.")));
    if (mesh.name.size() > kLongestMeshName)
      findings.add(*file, path, phrase(TRANSLATE_NOOP("problem", "The name of the mesh is longer than 1024 bytes.")));
  }
  const Value* const scale = object.find("scale_mm_per_unit");
  if (scale == nullptr) return mesh;
  mesh.m_per_unit = pointAt(object, "scale_mm_per_unit", true);
  if (!isMeshScale(mesh.m_per_unit))
    findings.add(*scale, object.pathOf("scale_mm_per_unit"),
                 phrase(TRANSLATE_NOOP("problem", "Each factor must be from 1e-6 to 1e6, or the same below 0.")));
  return mesh;
}

SolidForm readForm(ObjectReader& object, SolidKind kind) {
  if (kind == SolidKind::Mesh) return readMeshSolid(object);
  if (kind == SolidKind::Box) {
    BoxSolid box;
    box.size_m = pointAt(object, "size_mm", true);
    const Value* const value = object.find("size_mm");
    if (value != nullptr && !(box.size_m.minCoeff() > 0.0))
      object.findings().add(*value, object.pathOf("size_mm"),
                            phrase(TRANSLATE_NOOP("problem", "Each length must be above 0.")));
    return box;
  }
  const double radius_m = sizeAt(object, "radius_mm");
  if (kind == SolidKind::Sphere) return SphereSolid{radius_m};
  const double length_m = sizeAt(object, "length_mm");
  if (kind == SolidKind::Cylinder) return CylinderSolid{radius_m, length_m};
  return CapsuleSolid{radius_m, length_m};
}

LinkSolid readSolid(ObjectReader& object, const Value& value, std::size_t joints) {
  LinkSolid solid;
  const double link = numberAt(object, "link", true);
  if (!(link >= 0.0 && link <= static_cast<double>(joints) && link == std::floor(link))) {
    object.findings().add(value, object.pathOf("link"),
                          phrase(TRANSLATE_NOOP("problem",
                                                "This must be a whole number from 0, the base, to %1, the last "
                                                "link."),
                                 {std::to_string(joints)}));
  } else {
    solid.link = static_cast<std::size_t>(link);
  }
  SolidKind kind = SolidKind::Box;
  const Value* const type = object.find("type", true);
  if (type != nullptr) json::readWord(*type, object.pathOf("type"), kSolidKinds, kind, object.findings());
  const bool is_known = type != nullptr && std::any_of(std::begin(kSolidKinds), std::end(kSolidKinds),
                                                       [&](const auto& word) { return type->text == word.word; });
  if (!is_known) return solid;  // its other keys cannot be judged
  solid.form = readForm(object, kind);
  readPose(object, "X_WS", false, solid.X_WS);
  object.finish();
  return solid;
}

std::string lengthText(const char* key, double length_m) {
  return std::string(", \"") + key + "\": " + json::numberText(kMillimetrePerMetre * length_m);
}

std::string formText(const SolidForm& form) {
  if (const auto* const mesh = std::get_if<MeshSolid>(&form)) {
    const Vec3 mm = kMillimetrePerMetre * mesh->m_per_unit;
    return "\"mesh\", \"file\": " + json::quotedText(mesh->name) + ", \"scale_mm_per_unit\": [" +
           json::numberText(mm.x()) + ", " + json::numberText(mm.y()) + ", " + json::numberText(mm.z()) + "]";
  }
  if (const auto* const box = std::get_if<BoxSolid>(&form)) {
    const Vec3 mm = kMillimetrePerMetre * box->size_m;
    return R"("box", "size_mm": [)" + json::numberText(mm.x()) + ", " + json::numberText(mm.y()) + ", " +
           json::numberText(mm.z()) + "]";
  }
  if (const auto* const ball = std::get_if<SphereSolid>(&form))
    return "\"sphere\"" + lengthText("radius_mm", ball->radius_m);
  if (const auto* const rod = std::get_if<CylinderSolid>(&form))
    return "\"cylinder\"" + lengthText("radius_mm", rod->radius_m) + lengthText("length_mm", rod->length_m);
  const auto& capsule = std::get<CapsuleSolid>(form);
  return "\"capsule\"" + lengthText("radius_mm", capsule.radius_m) + lengthText("length_mm", capsule.length_m);
}

}  // namespace

void readSolids(ObjectReader& object, Model& model) {
  const Value* const list = object.find("solids");
  if (list == nullptr) return;
  Findings& findings = object.findings();
  if (!isKind(*list, json::JsonKind::Array, "solids",
              phrase(TRANSLATE_NOOP("problem", "a list of solids, in { } each")), findings))
    return;
  if (list->items.size() > kMaxSolids) {
    findings.add(*list, "solids",
                 phrase(TRANSLATE_NOOP("problem", "An arm has at most %1 solids; this one has %2."),
                        {std::to_string(kMaxSolids), std::to_string(list->items.size())}));
    return;
  }
  for (std::size_t index = 0; index < list->items.size(); ++index) {
    const std::string path = "solids[" + std::to_string(index) + "]";
    const Value& value = list->items[index];
    if (!isKind(value, json::JsonKind::Object, path, phrase(TRANSLATE_NOOP("problem", "an object in { }")), findings))
      continue;
    ObjectReader solid(value, path, phrase(TRANSLATE_NOOP("problem", "a solid")), findings);
    model.solids.push_back(readSolid(solid, value, model.joints.size()));
  }
}

std::string solidsText(const Model& model) {
  if (model.solids.empty()) return {};
  std::string text = ",\n  \"solids\": [\n";
  for (const LinkSolid& solid : model.solids) {
    const bool is_last = &solid == &model.solids.back();
    text += "    {\"link\": " + std::to_string(solid.link) + ", \"type\": " + formText(solid.form) +
            ", \"X_WS\": " + poseText(solid.X_WS) + (is_last ? "}\n" : "},\n");
  }
  return text + "  ]";
}

}  // namespace underact::arm
