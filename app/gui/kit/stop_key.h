#pragma once
#include <QObject>
#include <functional>

class QLineEdit;

namespace underact::gui {

/// A part of the window that lies over others until it is left: Esc leaves it before it stops the servo.
class LeftByEsc {
 public:
  LeftByEsc() = default;
  LeftByEsc(const LeftByEsc&) = delete;
  LeftByEsc& operator=(const LeftByEsc&) = delete;
  virtual ~LeftByEsc() = default;
  virtual bool isOpen() const = 0;
  virtual void leaveByEsc() = 0;
};

/// Esc closes what is on top: a menu, a list, a dialog, a LeftByEsc, or it empties the search field that has the focus.
/// Where there is nothing to close, or always() says that somebody may be pushed, it stops the servo; and in a dialog
/// with the property kEscStops, which is about the force. Shift+Esc stops it wherever the focus is.
class StopKey : public QObject {
  Q_OBJECT
 public:
  static constexpr const char* kEscStops = "escStops";
  /// The property of a button that does what this key does.
  static constexpr const char* kStops = "stops";

  /// window: contains the LeftByEsc widgets, and owns this.
  StopKey(std::function<void()> stop, std::function<bool()> always, QWidget* window);
  ~StopKey() override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Whether somebody may be pushed now.
  bool always() const { return always_(); }
  /// Whether Esc would stop the servo now.
  bool wouldStop() const { return always_() || !isSomethingOnTop(); }

 private:
  bool isSomethingOnTop() const;
  LeftByEsc* openPart() const;
  bool press();

  std::function<void()> stop_;
  std::function<bool()> always_;
  QWidget* window_;
  bool closes_ = false;  // the key that is being delivered
};

}  // namespace underact::gui
