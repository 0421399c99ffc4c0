#pragma once
#include <QObject>

#include "app/gui/compare/compared_scene.h"
#include "app/gui/feature/feature.h"
#include "app/gui/kit/theme.h"
#include "app/gui/model/scene_loading.h"

namespace underact::gui {

class CompareStrip;
class TwoViews;

/// Compares two scenes, or one scene with two sets of gains, on one motion: the felt scene on the left, the other one
/// on the right. The felt scene is edited as usual; the other one does not change until they are swapped.
class CompareTool : public QObject, public ServoListener {
  Q_OBJECT
 public:
  explicit CompareTool(const FeatureParts& parts);
  ~CompareTool() override;

  bool isOn() const;
  void setOn(bool on);
  const ComparedScene& beside() const { return beside_; }

  void add(const servo::TickRecord& record) override;
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

 private:
  void addActions();
  bool compareWith(const scene::Description& scene);
  bool swap();
  bool open(const QString& path);
  void chooseAndOpen();
  void takeLoaded();
  void showScenes();
  void tell(const QString& sentence);

  FeatureParts parts_;
  TwoViews* views_;
  CompareStrip* strip_ = nullptr;
  ComparedScene beside_;
  SceneLoading loading_;
  bool is_mirrored_ = false;  // the other scene
  int frames_ = 0;
};

}  // namespace underact::gui
