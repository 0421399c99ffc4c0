#pragma once
#include <QDialog>

#include "app/stream/live_stream.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace underact::gui {

/// Asks for the address to which live data are sent. Warns if they would leave this computer. Not modal.
class AddressDialog : public QDialog {
  Q_OBJECT
 public:
  AddressDialog(const QString& address, QWidget* parent);
  /// Why the address was refused; empty: it was not.
  void refuse(const QString& sentence);

 signals:
  /// The dialog stays open until it is accepted.
  void chosen(const underact::stream::Address& address);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void poll();
  void fit();
  void choose();

  QLineEdit* address_;
  QLabel *warning_, *refusal_;
  QPushButton* send_;
};

}  // namespace underact::gui
