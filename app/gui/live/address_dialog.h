#pragma once
#include <QDialog>

#include "app/stream/live_stream.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace underact::gui {

/// "Where do live data go?" Says plainly where they would leave this machine. Not modal.
class AddressDialog : public QDialog {
  Q_OBJECT
 public:
  AddressDialog(const QString& address, QWidget* parent);
  /// Why it cannot be; empty: nothing was refused.
  void refuse(const QString& sentence);

 signals:
  /// The dialog stays until it is accepted.
  void chosen(const underact::stream::Address& address);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void look();
  void fit();
  void choose();

  QLineEdit* address_;
  QLabel *warning_, *refusal_;
  QPushButton* send_;
};

}  // namespace underact::gui
