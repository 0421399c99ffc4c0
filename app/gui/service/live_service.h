#pragma once
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "app/gui/feature/feature.h"
#include "app/serve/server.h"
#include "app/serve/service.h"
#include "app/serve/token.h"

class QMenu;
class QToolButton;

namespace underact::gui {

class WindowScene;

/// Lets other programs of this computer listen to the window's scene and steer it, as "underact-cli serve" does: off at
/// each start of the program. A button in the status line says who is connected and who steers. Its actions are
/// service.on and service.take_back.
class LiveService : public QObject, public ServoListener {
  Q_OBJECT
 public:
  LiveService(Actions& actions, WindowScene& scene, QMainWindow* window);
  ~LiveService() override;
  void add(const servo::TickRecord& record) override;
  void present(const servo::Snapshot& snapshot) override;
  void poll(const servo::Snapshot& snapshot) override;
  void finish() override { stop(); }

  /// Serves from now on, at the usual port or, if that is in use, at a free one. Problems: it cannot listen.
  Problems start();
  /// Closes all connections: the force of programs ends, the scene stays.
  void stop();
  bool isOn() const { return service_ != nullptr; }
  /// Null while it is off.
  serve::Service* service() { return service_.get(); }
  int port() const { return server_ ? server_->port() : 0; }
  /// "ws://127.0.0.1:7171"; empty while it is off.
  QString address() const;
  /// The file with the token that programs need; empty while it is off.
  QString tokenFile() const;

 private:
  void addActions();
  bool hold();
  void addButton(QMainWindow* window);
  void step();
  void fillMenu();
  QString words() const;

  Actions& actions_;
  WindowScene& scene_;
  std::unique_ptr<serve::Service> service_;
  std::optional<serve::Server> server_;
  std::optional<serve::MadeToken> token_;
  QTimer beat_;
  QToolButton* button_ = nullptr;
  QMenu* menu_ = nullptr;
  bool is_stepping_ = false;
  bool is_fault_told_ = false;
};

}  // namespace underact::gui
