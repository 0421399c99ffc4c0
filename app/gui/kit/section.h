#pragma once
#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace underact::gui {

/// A heading that folds what stands below it.
class Section : public QWidget {
  Q_OBJECT
 public:
  /// key: "joints"; the heading is called panel.kinematics.joints.fold, or of another panel.
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
