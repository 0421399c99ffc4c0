#pragma once
#include <QToolButton>
#include <vector>

namespace underact::gui {

/// A button whose menu has all columns of a session to choose from, by name, with unit and meaning; several at once.
class ColumnButton : public QToolButton {
  Q_OBJECT
 public:
  static constexpr int kMax = 6;  // curves that can still be told apart

  ColumnButton(const QString& name, QWidget* parent);
  /// Indices in plotColumns(), in their order.
  const std::vector<int>& chosen() const { return chosen_; }
  /// By name; unknown ones are left out, and those beyond kMax.
  void choose(const QStringList& names);
  QStringList names() const;

 signals:
  void changed();

 private:
  void read();

  std::vector<QAction*> actions_;
  std::vector<int> chosen_;
};

}  // namespace underact::gui
