#include "app/gui/view/file_constraint.h"

#include <QFileInfo>
#include <utility>

#include "app/gui/view/workspace_picture.h"

namespace underact::gui {

Eigen::Matrix4d placeWithin(const Vec3& middle_mm) {
  Eigen::Matrix4d X_WM = Eigen::Matrix4d::Identity();
  const bool is_within = (middle_mm.cwiseAbs() - workspaceHalf_mm()).maxCoeff() <= 0.0;
  if (!is_within) X_WM.topRightCorner<3, 1>() = -middle_mm;
  return X_WM;
}

scene::Description sceneOfFile(const QString& path, const QString& about, scene::Constraint constraint) {
  scene::Description scene;
  scene.title = QFileInfo(path).completeBaseName().toStdString();
  scene.about = about.toStdString();
  scene.constraints.push_back(std::move(constraint));
  return scene;
}

}  // namespace underact::gui
