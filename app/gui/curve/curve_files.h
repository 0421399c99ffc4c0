#pragma once
#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/curve/curve_dialog.h"
#include "core/base/result.h"

namespace underact::gui {

class Actions;
class Document;
class LoadStrip;
class SceneFiles;

/// Curves from files of points: read in another thread, asked about, and put into a scene.
class CurveFiles : public QObject {
  Q_OBJECT
 public:
  CurveFiles(Document& document, SceneFiles& scenes, LoadStrip& loads, QWidget* window);
  void add(const QString& path);
  void chooseAndAdd();

 private:
  using Points = std::shared_ptr<const std::vector<Vec3>>;
  /// What a button of the dialog does with the curve; false: it stays.
  using Use = std::function<bool(CurveDialog& dialog, const scene::Constraint& constraint)>;
  void ask(const QString& path, const Points& points);
  void make(const QString& path, const Points& points, CurveDialog* dialog, const Use& use);

  Document& document_;
  SceneFiles& scenes_;
  LoadStrip& loads_;
  QWidget* window_;
};

/// By the end of its name.
bool isCurveFile(const QString& path);

/// As a scene holds it: in the middle of the workspace where it would lie outside of it.
scene::Constraint constraintOf(const QString& path, std::shared_ptr<const std::vector<Vec3>> points,
                               const CurveWish& wish);

/// "curve.add"
void addCurveActions(Actions& actions, CurveFiles& files);

}  // namespace underact::gui
