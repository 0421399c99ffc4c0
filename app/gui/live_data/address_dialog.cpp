#include "app/gui/live_data/address_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
AddressDialog::AddressDialog(const QString& address, QWidget* parent)
    : QDialog(parent),
      address_(new QLineEdit(address, this)),
      warning_(messageLabel("dialog.live.warning", tr("Warning"), "amber", this)),
      refusal_(messageLabel("dialog.live.refusal", tr("Error message"), "alarm", this)) {
  setObjectName("dialog.live");
  for (QLabel* label : {warning_, refusal_}) label->hide();
  setWindowTitle(tr("Send live data to"));
  setModal(false);
  setMinimumWidth(460);
  auto* about = new QLabel(tr("Each tick is sent as one JSON object over UDP. To receive it in PlotJuggler, start its "
                              "source “UDP Server”, whose default port is %1.")
                               .arg(stream::kPort),
                           this);
  about->setWordWrap(true);
  nameWidget(address_, "dialog.live.address", tr("Address"),
             tr("A port, an IP address, or both: 9870, 192.168.1.20, 192.168.1.20:9870."));
  address_->selectAll();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  send_ = buttons->addButton(tr("&Send"), QDialogButtonBox::ActionRole);
  nameWidget(send_, "dialog.live.send", tr("Send"));
  send_->setDefault(true);
  QPushButton* cancel = buttons->button(QDialogButtonBox::Cancel);
  nameWidget(cancel, "dialog.live.cancel", tr("Cancel"));
  cancel->setIcon({});
  auto* form = new QFormLayout;
  form->addRow(tr("&Address"), address_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(about);
  column->addLayout(form);
  column->addWidget(warning_);
  column->addWidget(refusal_);
  column->addWidget(buttons);
  connect(address_, &QLineEdit::textChanged, this, &AddressDialog::poll);
  connect(send_, &QPushButton::clicked, this, &AddressDialog::choose);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  poll();
}

void AddressDialog::refuse(const QString& sentence) {
  showMessage(refusal_, sentence);
  fit();
}

void AddressDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fit();  // the style is known only now
}

// A layout does not make room for wrapped lines by itself.
void AddressDialog::fit() {
  layout()->activate();
  resize(width(), layout()->totalHeightForWidth(width()));
}

void AddressDialog::poll() {
  refuse({});
  const Result<stream::Address> read = stream::readAddress(address_->text().trimmed().toStdString());
  const bool leaves = read && !read.value().isThisMachine();
  if (leaves) {
    warning_->setText(tr("%1 is not this computer. What the hand does and feels is sent unencrypted: anyone on the "
                         "network between can read it.")
                          .arg(QString::fromStdString(read.value().host)));
  }
  warning_->setVisible(leaves);
  fit();
}

void AddressDialog::choose() {
  const Result<stream::Address> read = stream::readAddress(address_->text().trimmed().toStdString());
  if (read)
    emit chosen(read.value());
  else
    refuse(sentencesOf(read.problems()));
}

}  // namespace underact::gui
