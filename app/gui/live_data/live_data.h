#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "app/gui/feature/feature.h"
#include "app/stream/live_stream.h"
#include "core/servo/host.h"

class QWidget;

namespace underact::gui {

/// Sends every tick to PlotJuggler while it is on: off at each start of the program, and to this computer unless
/// another address was given since. Its actions are live.send and live.address.
class LiveData : public QObject, public ServoListener {
  Q_OBJECT
 public:
  LiveData(ServoFacts servo, const ServoRate& rate, const Recording& recording, StatusLine& status, Actions& actions,
           QWidget* window);
  void add(const servo::TickRecord& record) override {
    if (stream_) stream_->send(record);
  }
  void present(const servo::Snapshot& snapshot) override;
  bool isSending() const { return stream_.has_value(); }
  const stream::Address& address() const { return address_; }
  /// Sends to address from now on. Problems: it cannot be reached; then the previous address is kept.
  Problems sendTo(const stream::Address& address);
  void stop();
  /// "live data to 127.0.0.1:9870"; empty: nothing is sent.
  QString where() const;
  /// How many ticks were sent, and whether another computer receives them.
  QString details() const;

 private:
  void addActions(QWidget* window);
  void askForAddress(QWidget* window, const QString& refusal);

  ServoFacts servo_;
  Actions& actions_;
  StatusLine& status_;
  const Recording& recording_;
  stream::Address address_;
  std::optional<stream::LiveStream> stream_;
};

/// "127.0.0.1:9870", "[::1]:9870": as readAddress() reads it.
QString addressText(const stream::Address& address);

}  // namespace underact::gui
