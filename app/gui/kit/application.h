#pragma once
#include <QApplication>
#include <functional>
#include <string>

namespace underact::gui {

/// The program, which an exception in the window's own code does not end: it is told, and the window goes on.
class Application : public QApplication {
 public:
  /// what: the exception's own message.
  using Tell = std::function<void(const std::string& what)>;

  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;
  /// Whom to tell; empty: nobody. The one there is, if the program runs as an Application.
  static void onException(Tell tell);

 private:
  void tell(const std::string& what) noexcept;

  Tell tell_;
  bool telling_ = false;  // an exception from telling of one is not told
};

}  // namespace underact::gui
