#pragma once
#include <QComboBox>
#include <QString>

namespace underact::gui {

/// A chooser as narrow as a panel needs it, whose wheel scrolls the panel until it has the focus.
class PanelChooser : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

/// On Linux Qt tells a screen reader what is chosen in place of the name: the description has to say the name too.
void nameChooser(QComboBox* box, const QString& spoken, const QString& tip);

QComboBox* chooser(const char* name, const QString& spoken, const QString& tip, QWidget* parent);

}  // namespace underact::gui
