#pragma once
#include "app/gui/kit/painted.h"

class QLabel;

namespace underact::gui {

/// A share from 0 to 1 as a bar with its name and its value in words; quiet until it acts, then vermillion, with the
/// word, and a line below for what it did before.
class ShareBar : public Painted {
  Q_OBJECT
 public:
  /// What it is called, and room for the longest name and value of those that stand in line.
  struct Words {
    QString name, tip, widest_name, widest_value;
  };
  /// with_note: there is a line below.
  ShareBar(const QString& object_name, const Words& words, bool with_note, QWidget* parent = nullptr);
  void present(double share, const QString& value, bool acts);
  void setNote(const QString& note);
  bool acts() const { return acts_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double share_ = 0.0;
  bool acts_ = false;
  QLabel *track_, *value_, *note_ = nullptr;
};

}  // namespace underact::gui
