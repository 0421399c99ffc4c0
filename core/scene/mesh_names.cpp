#include "core/scene/mesh_names.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/base/printed.h"
#include "core/base/translate.h"
#include "core/json/text.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxEntries = 20'000, kDeepest = 2;

// After each mark the letters that Unicode has with it, each before the letter without it.
constexpr std::u32string_view kAccents =
    U"\u0300ÀAÈEÌIÒOÙUàaèeìiòoùu\u0301ÁAÉEÍIÓOÚUÝYáaéeíióoúuýyĆCćcĹLĺlŃNńnŔRŕrŚSśsŹZźz\u0302ÂAÊEÎIÔOÛUâaêeîiôoûuĈCĉcĜG"
    U"ĝgĤHĥhĴJĵjŜSŝsŴWŵwŶYŷy\u0303ÃAÑNÕOãañnõoĨIĩiŨUũu\u0304ĀAāaĒEēeĪIīiŌOōoŪUūu\u0306ĂAăaĔEĕeĞGğgĬIĭiŎOŏoŬUŭuЙИйиЎУўу"
    U"\u0307ĊCċcĖEėeĠGġgİIŻZżz\u0308ÄAËEÏIÖOÜUäaëeïiöoüuÿyŸYЁЕёеЇІїі\u030AÅAåaŮUůu\u030BŐOőoŰUűu\u030CČCčcĎDďdĚEěeĽLľl"
    U"ŇNňnŘRřrŠSšsŤTťtŽZžz\u0327ÇCçcĢGģgĶKķkĻLļlŅNņnŖRŗrŞSşsŢTţt\u0328ĄAąaĘEęeĮIįiŲUųu";

bool isMark(char32_t letter) {
  return letter >= 0x300 && letter < 0x370;
}

/// What names that differ in form alone have in common.
std::u32string folded(const std::string& name) {
  std::u32string form;
  for (std::size_t at = 0, length = 0; at < name.size(); at += length) {
    length = std::max<std::size_t>(characterLength(name, at), 1);
    char32_t letter = static_cast<unsigned char>(name[at]) & (length > 1 ? 0xFFU >> (length + 1) : 0xFFU), mark = 0;
    for (std::size_t k = 1; k < length; ++k) letter = letter << 6U | (static_cast<unsigned char>(name[at + k]) & 0x3FU);
    std::size_t k = length == 1 || isMark(letter) ? kAccents.size() : 0;
    for (; k < kAccents.size() && kAccents[k] != letter; k += isMark(kAccents[k]) ? 1 : 2) {
      if (isMark(kAccents[k])) mark = kAccents[k];
    }
    if (k < kAccents.size()) letter = kAccents[k + 1];
    form += letter >= U'A' && letter <= U'Z' ? letter - U'A' + U'a' : letter;
    if (k < kAccents.size()) form += mark;
  }
  return form;
}

/// The files in the folder and not deep below, from it; none where there are too many.
std::vector<std::string> filesBelow(fs::path folder) {
  std::vector<std::string> files;
  if (folder.empty()) folder = ".";
  std::error_code error;
  int left = kMaxEntries;
  constexpr auto kSkip = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator one(folder, kSkip, error), last; !error && one != last; one.increment(error)) {
    if (--left < 0) return {};
    if (one.depth() == kDeepest) one.disable_recursion_pending();
    if (one->is_regular_file(error)) files.push_back(one->path().lexically_relative(folder).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The greatest number of steps up in a relative path. More of them only reflect where on this disk the mesh is.
constexpr std::ptrdiff_t kMaxStepsUp = 2;

/// The name of what is at path in a scene in that file.
std::string nameFrom(const std::string& path, const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error).lexically_normal();
  if (error) return path;
  const fs::path relative = whole.lexically_relative(fs::path(file).parent_path().lexically_normal());
  const std::ptrdiff_t steps_up = std::count(relative.begin(), relative.end(), fs::path(".."));
  const bool is_near = !relative.empty() && steps_up <= kMaxStepsUp;
  return is_near ? relative.generic_string() : whole.string();
}

}  // namespace

std::string plainName(const fs::path& folder, std::string name) {
  std::error_code error;
  if (fs::exists(folder / name, error)) return name;
  if (name.starts_with("file://")) name.erase(0, 7);
  std::replace(name.begin(), name.end(), '\\', '/');
  const char* const home = std::getenv("HOME");
  if (name.starts_with("~/") && home != nullptr) name.replace(0, 1, home);
  while (name.ends_with(' ')) name.pop_back();
  return name;
}

std::string fileMeant(const fs::path& folder, const std::string& name) {
  const fs::path plain = plainName(folder, name);
  std::error_code error;
  if (fs::exists(folder / plain, error)) return (folder / plain).string();
  const std::u32string form = folded(plain.lexically_normal().string());
  std::vector<std::string> files = filesBelow(folder);
  std::erase_if(files, [&](const std::string& file) { return folded(file) != form; });
  return files.size() == 1 ? (folder / files[0]).string() : (folder / name).string();
}

Problems withNearest(Problems problems, const std::string& name, const Description& scene) {
  const fs::path folder = fs::path(scene.file).parent_path();
  std::error_code error;
  if (scene.file.empty() || fs::exists(fileMeant(folder, name), error)) return problems;
  const std::vector<std::string> files = filesBelow(folder);
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(fs::path(file).filename().string());
  const std::string nearest = json::nearestWord(fs::path(plainName(folder, name)).filename().string(), names);
  const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), nearest) - names.begin());
  if (at == files.size()) return problems;
  const Sentence note = phrase(TRANSLATE_NOOP("problem", "The nearest name is %1."), {json::shown(files[at])});
  problems[0].sentence = oneAfterAnother({problems[0].sentence, note});
  return problems;
}

Description namedFrom(Description scene, const std::string& file) {
  for (Constraint& constraint : scene.constraints) {
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    if (mesh != nullptr) mesh->file = nameFrom(pathOf(mesh->file, scene), file);
    if (curve != nullptr) curve->file = nameFrom(pathOf(curve->file, scene), file);
  }
  if (isArmFile(scene.arm) && scene.arm_text.empty()) {
    const std::string name = nameFrom(pathOf(scene.arm, scene), file);
    scene.arm = isArmFile(name) ? name : "./" + name;
  }
  scene.file = file;
  return scene;
}

}  // namespace underact::scene
