#pragma once
#include <memory>

#include "app/serve/endpoint.h"
#include "app/serve/service.h"

namespace underact::serve {

inline constexpr int kHaplyPort = 10001;

/// The subset of Haply's Inverse service that its clients use (v3.1 and v3.5, JSON over a WebSocket; the published
/// client crate "haply" 1.3 has the messages): the arm as an Inverse3, its stylus and buttons as a wireless VerseGrip.
/// One client, without a token: it steers as a client of the service does, holds the lease, and its force ends 50 ms
/// after the last frame that has one. The first message has the whole state with its configuration; after it each
/// frame of the client is answered by the state of the next tick.
/// Theirs: m, N, deg; origin at the base, x to the right, y away from the person, z up. p_H = R_HW p_W + p_HW.
class HaplyService final : public Endpoint {
 public:
  /// service: outlives this, and is polled before it.
  explicit HaplyService(Service& service);
  ~HaplyService() override;

  int connect() override;
  void disconnect(int connection) override;
  void receive(int connection, Frame frame, double now_s) override;
  bool hasMessage(int connection) const override;
  Message takeMessage(int connection) override;
  bool mayBeRead(int connection) const override;
  bool closes(int connection) const override;
  void poll(double now_s) override;
  bool isBusy() const override;
  bool isKnown(int connection) const override;
  HttpAnswer answer(const HttpRequest& request) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::serve
