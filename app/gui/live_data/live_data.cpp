#include "app/gui/live_data/live_data.h"

#include <QAction>
#include <QMainWindow>
#include <utility>

#include "app/gui/feature/status_line.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/words.h"
#include "app/gui/live_data/address_dialog.h"
#include "app/gui/model/recording.h"
#include "app/gui/model/servo_rate.h"

namespace underact::gui {

QString addressText(const stream::Address& address) {
  const QString host = QString::fromStdString(address.host);
  return QString(host.contains(':') ? "[%1]:%2" : "%1:%2").arg(host).arg(address.port);
}

LiveData::LiveData(ServoFacts servo, const ServoRate& rate, const Recording& recording, StatusLine& status,
                   Actions& actions, QWidget* window)
    : QObject(window), servo_(servo), actions_(actions), status_(status), recording_(recording) {
  addActions(window);
  connect(&rate, &ServoRate::changed, this, [this](int, int rate_hz) {
    if (stream_) stream_->setRate(rate_hz);
  });
}

void LiveData::present(const servo::Snapshot&) {
  if (stream_) stream_->setSession(recording_.sessionId());
  status_.setLive(where(), details());
}

void LiveData::addActions(QWidget* window) {
  actions_.add({"live.send",
                tr("Send &live data to PlotJuggler"),
                QKeySequence("Ctrl+Alt+J"),
                tr("Sends every tick as JSON over UDP: to this computer, unless you give another address."),
                {},
                {},
                true},
               [this, window](const QVariantList& on) {
                 if (!on.value(0).toBool()) {
                   stop();
                   return true;
                 }
                 const Problems problems = sendTo(address_);
                 if (!problems.empty()) askForAddress(window, sentencesOf(problems));
                 return problems.empty();
               });
  actions_.add({"live.address", tr("Send live &data to…"), QKeySequence("Ctrl+Alt+A"),
                tr("Sends every tick to an address that you give.")},
               [this, window](const QVariantList& address) {
                 if (address.isEmpty()) {
                   askForAddress(window, {});
                   return true;
                 }
                 const Result<stream::Address> read = stream::readAddress(address.first().toString().toStdString());
                 return read && sendTo(read.value()).empty();
               });
}

void LiveData::askForAddress(QWidget* window, const QString& refusal) {
  auto* dialog = new AddressDialog(addressText(address_), window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->refuse(refusal);
  connect(dialog, &AddressDialog::chosen, this, [this, dialog](const stream::Address& address) {
    const Problems problems = sendTo(address);
    if (problems.empty())
      dialog->accept();
    else
      dialog->refuse(sentencesOf(problems));
  });
  dialog->show();
  dialog->activateWindow();
}

Problems LiveData::sendTo(const stream::Address& address) {
  Result<stream::LiveStream> opened = stream::LiveStream::open(address, servo_.rateHz());
  if (!opened) return opened.problems();
  stream_ = std::move(opened).value();
  address_ = address;
  actions_.find("live.send")->setChecked(true);
  return {};
}

void LiveData::stop() {
  stream_.reset();
  actions_.find("live.send")->setChecked(false);
}

QString LiveData::where() const {
  return isSending() ? tr("live data to %1").arg(addressText(address_)) : QString();
}

QString LiveData::details() const {
  if (!isSending()) return {};
  const QString much = tr("%1 ticks sent, %2 could not be sent.").arg(stream_->sent()).arg(stream_->lost());
  return address_.isThisMachine() ? much : much + '\n' + tr("What the hand does is sent to another computer.");
}

}  // namespace underact::gui
