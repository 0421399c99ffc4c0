#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "app/stream/live_stream.h"
#include "core/servo/host.h"

class QWidget;

namespace underact::gui {

class Actions;

/// Every tick to PlotJuggler, while it is asked for: off at each start, and to this machine unless an address was given
/// since. Its actions are live.send and live.address.
class LiveData : public QObject {
  Q_OBJECT
 public:
  LiveData(servo::Host& host, Actions& actions, QWidget* window);
  /// Every tick, in order.
  void add(const servo::TickRecord& record) {
    if (stream_) stream_->send(record);
  }
  bool isSending() const { return stream_.has_value(); }
  const stream::Address& address() const { return address_; }
  /// Sends to address from now on. Problems: there is no way to it; then what was sent before goes on.
  Problems sendTo(const stream::Address& address);
  void stop();
  void setRate(int rate_hz) {
    if (stream_) stream_->setRate(rate_hz);
  }
  /// "live data to 127.0.0.1:9870"; empty: nothing is sent.
  QString where() const;
  /// How much went out, and whether another machine gets it.
  QString details() const;

 private:
  void addActions(QWidget* window);
  void askForAddress(QWidget* window, const QString& refusal);

  servo::Host& host_;
  Actions& actions_;
  stream::Address address_;
  std::optional<stream::LiveStream> stream_;
};

/// "127.0.0.1:9870", "[::1]:9870": as readAddress() takes it.
QString addressText(const stream::Address& address);

}  // namespace underact::gui
