#include "core/arm/solid_place.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/arm/xml_bounds.h"
#include "core/base/translate.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxParents = 8;
constexpr std::string_view kPackage = "package://";

/// Links resolved; none: it does not exist, or nobody may look.
std::optional<fs::path> realOf(const fs::path& path) {
  std::error_code error;
  fs::path real = fs::canonical(path, error);
  if (error) return {};
  return real;
}

bool isPackage(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "package.xml", error);
}

bool isWithin(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

/// What a name means, and the folder that it may not leave: below one without links, so that a link leaves it.
struct Meant {
  fs::path file, folder;
};

/// Of a relative name: the folder of the arm's file, or the package that it is a part of.
Meant besideArm(const fs::path& folder, const fs::path& name) {
  fs::path package = folder;
  for (int up = 0; up <= kMaxParents && package != package.root_path(); ++up, package = package.parent_path()) {
    if (isPackage(package)) return {folder / name, package};
  }
  return {folder / name, folder};
}

/// Whether package.xml in a folder says that the package has this name: a folder out of an archive is NAME-main.
bool isPackageNamed(const fs::path& folder, const std::string& name) {
  constexpr std::size_t kLargestManifest = std::size_t{64} << 10;
  if (!isPackage(folder)) return false;
  const Result<std::string> text = json::readTextFile((folder / "package.xml").string(), Sentence(), kLargestManifest);
  tinyxml2::XMLDocument manifest;
  if (!text || excessOf(text.value())) return false;
  if (manifest.Parse(text.value().data(), text.value().size()) != tinyxml2::XML_SUCCESS) return false;
  const tinyxml2::XMLElement* const root = manifest.RootElement();
  const tinyxml2::XMLElement* const name_element = root == nullptr ? nullptr : root->FirstChildElement("name");
  return name_element != nullptr && name_element->GetText() != nullptr && name_element->GetText() == name;
}

/// Of package://NAME/rest; none: there is no such package.
std::optional<Meant> inPackage(const fs::path& folder, const fs::path& package, const fs::path& rest) {
  fs::path at = folder;
  for (int up = 0; up <= kMaxParents && at != at.root_path(); ++up, at = at.parent_path()) {
    const bool is_own = at == folder;  // what it contains may be opened in any case
    if (at.filename() == package && (is_own || isPackage(at))) return Meant{at / rest, at};
    std::error_code error;
    if (fs::is_directory(at / package, error) && (is_own || isPackage(at / package)))
      return Meant{at / package / rest, is_own ? at : at / package};
    if (isPackageNamed(at, package.string())) return Meant{at / rest, at};
  }
  return {};
}

Sentence outside(const std::string& name) {
  return phrase(
      TRANSLATE_NOOP("problem",
                     "The mesh %1 is not drawn: its name leads out of the folder of the arm's file, or of the "
                     "package that this folder is in."),
      {json::shown(name)});
}

}  // namespace

Result<std::string> fileOfSolid(const Model& model, const MeshSolid& mesh) {
  const auto problem = [&](Sentence sentence) { return Problems{{std::move(sentence), mesh.place}}; };
  if (model.folder.empty())
    return problem(phrase(TRANSLATE_NOOP("problem",
                                         "The mesh %1 is not drawn: a recording contains the file of the arm, not the "
                                         "meshes beside it."),
                          {json::shown(mesh.name)}));
  const std::string_view name = mesh.name;
  const bool is_odd = name.size() > kLongestMeshName || std::any_of(name.begin(), name.end(), [](char letter) {
                        return static_cast<unsigned char>(letter) < 0x20;
                      });
  const bool is_package = name.starts_with(kPackage);
  if (is_odd || (!is_package && (name.find("://") != std::string_view::npos || fs::path(name).is_absolute())))
    return problem(outside(mesh.name));
  const std::optional<fs::path> folder = realOf(model.folder);
  std::optional<Meant> meant;
  if (folder && is_package) {
    const std::string_view rest = name.substr(kPackage.size());
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view package = rest.substr(0, slash);
    if (package.empty() || package == "." || package == "..") return problem(outside(mesh.name));
    meant = inPackage(*folder, package, fs::path(rest.substr(slash)).relative_path());
    if (!meant)
      return problem(phrase(TRANSLATE_NOOP("problem",
                                           "The mesh %1 is not drawn: there is no such package in the folder of the "
                                           "arm's file, and none with a package.xml in the folders above."),
                            {json::shown(mesh.name)}));
  } else if (folder) {
    meant = besideArm(*folder, name);
  }
  const std::optional<fs::path> file = meant ? realOf(meant->file) : std::nullopt;
  // A name that leads outside says so, whether or not there is a file: what exists elsewhere is nobody's business.
  const bool leads_out = meant && !isWithin(meant->file.lexically_normal(), meant->folder);
  if (leads_out || (file && !isWithin(*file, meant->folder))) return problem(outside(mesh.name));
  if (!file)
    return problem(phrase(TRANSLATE_NOOP("problem", "The mesh %1 is not drawn: there is no such file."),
                          {json::shown(mesh.name)}));
  return file->string();
}

Problems solidProblems(const Model& model) {
  Problems problems = model.notes;
  if (model.folder.empty()) return problems;
  for (const LinkSolid& solid : model.solids) {
    const auto* const mesh = std::get_if<MeshSolid>(&solid.form);
    if (mesh == nullptr) continue;
    const Result<std::string> file = fileOfSolid(model, *mesh);
    if (!file) problems.push_back(file.problems().front());
  }
  return problems;
}

Result<Model> withFolderOf(const std::string& path, Result<Model> model) {
  if (!model) return model;
  const fs::path folder = fs::path(path).parent_path();
  model.value().folder = folder.empty() ? "." : folder.string();
  return model;
}

bool isMeshScale(const Vec3& m_per_unit) {
  const Vec3 sizes = m_per_unit.cwiseAbs();
  return sizes.allFinite() && sizes.minCoeff() >= kMinMetresPerUnit && sizes.maxCoeff() <= kMaxMetresPerUnit;
}

}  // namespace underact::arm
