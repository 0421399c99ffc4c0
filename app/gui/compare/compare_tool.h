#pragma once
#include <QObject>

#include "app/gui/compare/beside.h"
#include "app/gui/scene_loading.h"
#include "app/gui/theme.h"

class QWidget;

namespace underact::gui {

class Actions;
class CompareStrip;
class Document;
class SceneFiles;
class SceneView;
class TwoViews;

/// Two scenes, or one with two sorts of gains, compared on one motion: to the left what is felt, to the right what the
/// other one would do. What is felt is edited as always; the other one stays as it was, until they are swapped.
class CompareTool : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    servo::Host& host;
    Document& document;
    SceneFiles& files;
    SceneView& view;
    Actions& actions;
  };
  /// middle: what view and strip stand in.
  CompareTool(const Parts& parts, QWidget* middle);
  ~CompareTool() override;

  QWidget* views() const;  // the view is in it
  QWidget* strip() const;
  bool isOn() const;
  void setOn(bool on);
  const Beside& beside() const { return beside_; }

  /// Every tick, in order.
  void add(const servo::TickRecord& record);
  /// Each frame.
  void present(const servo::Snapshot& snapshot);
  void setTheme(const Theme& theme);

 private:
  void addActions();
  bool compareWith(const scene::Description& scene);
  bool swap();
  bool open(const QString& path);
  void chooseAndOpen();
  void takeLoaded();
  void showScenes();
  void tell(const QString& sentence);

  Parts parts_;
  TwoViews* views_;
  CompareStrip* strip_ = nullptr;
  Beside beside_;
  SceneLoading loading_;
  bool is_mirrored_ = false;  // the scene beside
  int frames_ = 0;
};

}  // namespace underact::gui
