#include "app/gui/picture.h"

#include <QImage>
#include <cstdio>

#include "app/gui/simulated_host.h"
#include "app/gui/view/scene_view.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"

namespace underact::gui {

constexpr QSize kSize(1280, 960);

int drawPicture(const std::string& scene_file, const std::string& out) {
  Result<scene::Description> scene = scene::readSceneFile(scene_file);
  SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
  Problems problems = scene ? scene::loadMeshes(scene.value()) : scene.problems();
  if (problems.empty()) problems = simulated.host->load(scene.value());
  for (const Problem& problem : problems) std::fprintf(stderr, "%s\n", describe(problem).c_str());
  if (!problems.empty()) return problems.front().place.line == 0 ? 4 : 1;
  simulated.host->run(1);  // the stylus is drawn where the arm says that it is
  SceneView view;
  view.setAttribute(Qt::WA_DontShowOnScreen);
  view.resize(kSize);
  view.show();
  view.setTheme(Theme::light());
  view.setScene(scene.value());
  view.present(simulated.host->snapshot());
  const QImage image = view.picture();
  if (!image.isNull() && image.save(QString::fromStdString(out), "PNG")) return 0;
  std::fprintf(stderr, "%s cannot be written.\n", out.c_str());
  return 4;
}

}  // namespace underact::gui
