#include "app/guide/make.h"

#include "app/guide/scene_page.h"
#include "app/guide/scene_schema.h"
#include "app/guide/site.h"

namespace underact::guide {
namespace {

int refuse(const Problems& problems, std::ostream& errors) {
  for (const Problem& problem : problems) errors << describe(problem) << '\n';
  return 1;
}

int print(const Result<std::string>& page, std::ostream& out, std::ostream& errors) {
  if (!page) return refuse(page.problems(), errors);
  out << page.value() << std::flush;
  return out ? 0 : 4;
}

}  // namespace

int printSceneSchema(const std::string& schema_file, std::ostream& out, std::ostream& errors) {
  return print(sceneSchema(schema_file), out, errors);
}

int printSceneKeys(const std::string& schema_file, std::ostream& out, std::ostream& errors) {
  return print(scenePage(schema_file), out, errors);
}

int printSceneList(const std::string& folder, std::ostream& out, std::ostream& errors) {
  return print(sceneList(folder), out, errors);
}

int makeSite(const std::string& folder, const std::string& out_folder, std::ostream& errors) {
  const Result<Guide> guide = readGuide(folder);
  if (!guide) return refuse(guide.problems(), errors);
  const Problems problems = writeSite(guide.value(), out_folder);
  return problems.empty() ? 0 : refuse(problems, errors);
}

}  // namespace underact::guide
