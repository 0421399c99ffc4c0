#include "app/gui/feature/feature.h"

#include <QBoxLayout>
#include <QMainWindow>

#include "app/gui/mesh/mesh_files.h"
#include "app/gui/mesh/section_strip.h"

namespace underact::gui {
namespace {

void makeMesh(const FeatureParts& parts, Followers& followers) {
  auto* files = new MeshFiles(parts.document, parts.files, parts.loads, parts.window);
  addMeshActions(parts.actions, *files);
  auto* section = new SectionStrip(parts.view, parts.actions, parts.middle.parentWidget());
  parts.middle.addWidget(section);
  followers.push_back(section);
}

}  // namespace

FeatureRow meshFeature() {
  return {.pages = {{"section", "meshes"},
                    {"dialog.add_mesh", "meshes"},
                    {"dialog.mesh", "meshes"},
                    {"dialog.mesh_problems", "meshes"}},
          .make = makeMesh,
          .opens = isMeshFile,
          .open_action = "mesh.add"};
}

}  // namespace underact::gui
