#pragma once
#include "app/gui/kit/painted.h"

class QLabel;

namespace underact::gui {

/// A distance as a bar from 0 to the farthest, with a mark at the threshold of near and the number; below the threshold
/// it is amber and says "near".
class DistanceBar : public Painted {
  Q_OBJECT
 public:
  struct Scale {
    double near_below = 0.0;  // "near" is a macro of Windows
    double farthest = 1.0;
    int decimals = 1;
    QString unit;  // " mm"
  };
  DistanceBar(const QString& object_name, const QString& name, const QString& tip, const Scale& scale,
              QWidget* parent = nullptr);
  void setFarthest(double farthest);
  void present(double distance);
  bool isNear() const { return distance_ < scale_.near_below; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString name_;
  Scale scale_;
  double distance_ = 0.0;
  QLabel *track_, *value_, *word_;
};

}  // namespace underact::gui
