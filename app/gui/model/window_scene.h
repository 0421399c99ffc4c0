#pragma once
#include <QObject>
#include <QString>
#include <functional>

#include "app/serve/steered.h"

namespace underact::gui {

class Actions;
class Document;
class Player;
class Recording;

/// What a program that steers the window's scene needs of it; it outlives the scene.
struct WindowSceneParts {
  servo::Host& host;
  Document& document;
  const Player& player;
  Recording& recording;
  const Actions& actions;
};

/// The window's scene as programs steer it: their edits are steps that the person can undo, their recordings those of
/// the window.
class WindowScene final : public QObject, public serve::Steered {
  Q_OBJECT
 public:
  WindowScene(const WindowSceneParts& parts, QObject* parent);
  /// drain: gives everybody in the window the ticks since the last frame, among them the service.
  void setDrain(std::function<void()> drain) { drain_ = std::move(drain); }

  servo::Host& host() override { return parts_.host; }
  void drain(serve::Service& service) override;
  std::string refusal() const override;
  Problems load(const scene::Description& scene, const std::string& by) override;
  Problems edit(const scene::Description& edited, std::int64_t over_ticks, const std::string& by) override;
  std::optional<serve::RecordingNow> recording() override;
  Problems startRecording(const std::string& name) override;
  Result<serve::RecordingNow> endRecording() override;
  void mark(const std::string& text) override;

 private:
  WindowSceneParts parts_;
  std::function<void()> drain_;
  bool is_editing_ = false;     // a program, just now
  bool has_own_edits_ = false;  // of the person, not saved
  std::string last_by_;         // whose edits the last step of undo has; empty: the person's
  int gesture_ = 0;
  QString clients_path_;  // of the recording that a client has begun
};

}  // namespace underact::gui
