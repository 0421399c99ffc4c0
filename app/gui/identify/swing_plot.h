#pragma once
#include <QWidget>
#include <memory>

#include "app/gui/identify/swing_picture.h"
#include "app/gui/theme.h"

namespace underact::gui {

/// Swings against time: the target, the tip, and the body that was fitted. It moves when asked.
class SwingPlot : public QWidget {
  Q_OBJECT
 public:
  SwingPlot(const QString& object_name, QWidget* parent);
  ~SwingPlot() override;
  void present(const SwingPicture& picture);
  void setTheme(const Theme& theme);
  QImage picture();
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
