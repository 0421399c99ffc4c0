#pragma once
#include "app/gui/kit/painted.h"

class QLabel;

namespace underact::gui {

/// A share from 0 to 1 as a bar with a name and a value in words: grey until it acts, then vermillion; optionally with
/// a note below about the last time it acted.
class ShareBar : public Painted {
  Q_OBJECT
 public:
  /// The name and the tip, and the longest name and value of all bars in the column, for their widths.
  struct Words {
    QString name, tip, widest_name, widest_value;
  };
  /// with_note: with a line below for a note.
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
