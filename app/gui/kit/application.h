#pragma once
#include <QApplication>
#include <functional>
#include <string>

namespace underact::gui {

/// The application. All labels show plain text, unless they were given another format. An exception in the window's own
/// code does not end it: it is reported, and the window continues.
class Application : public QApplication {
 public:
  /// what: the exception's own message.
  using Tell = std::function<void(const std::string& what)>;

  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;
  /// Who is told; empty: nobody. Applies to the running Application, if there is one.
  static void onException(Tell tell);

 private:
  void tell(const std::string& what) noexcept;

  Tell tell_;
  bool telling_ = false;  // an exception thrown while reporting is not reported
};

}  // namespace underact::gui
