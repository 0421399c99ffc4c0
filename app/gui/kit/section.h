#pragma once
#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace underact::gui {

/// A heading that folds the content below it.
class Section : public QWidget {
  Q_OBJECT
 public:
  /// key: "joints"; the heading is then named panel.kinematics.joints.fold, for the panel "kinematics".
  Section(const QString& key, const QString& title, const QString& tip, QWidget* parent = nullptr,
          const QString& panel = QStringLiteral("kinematics"));
  QVBoxLayout& column() { return *column_; }
  bool isOpen() const { return !content_->isHidden(); }
  void setOpen(bool open);

 private:
  QToolButton* fold_;
  QWidget* content_;
  QVBoxLayout* column_;
};

}  // namespace underact::gui
