#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "core/sweep/lead.h"
#include "core/sweep/messages.h"
#include "core/sweep/workers.h"

namespace underact::sweep {
namespace {

/// A rank that runs the cells it is given.
class Follower {
 public:
  Follower(const Sweep& sweep, Team& team, int threads, const std::function<bool()>& interrupted)
      : team_(team), interrupted_(interrupted), workers_(sweep, threads) {
    tell({MessageKind::Hello, sweep.fingerprint});
  }

  void run() {
    while (!stopping_ || workers_.held() > 0) {
      report(workers_.take(kLookAtLetters));
      while (const std::optional<Message> message = team_.receive()) obey(readOrder(message->text));
      if (!told_interrupt_ && interrupted_()) {
        told_interrupt_ = true;
        tell({MessageKind::Interrupted});
      }
    }
    tell({MessageKind::Bye});
  }

 private:
  void tell(const Report& report) { team_.send(0, write(report)); }

  void report(const std::vector<Finished>& finished) {
    Report rows{MessageKind::Done};
    for (const Finished& one : finished) {
      if (one.row) {
        rows.rows.push_back({one.cell, one.row.value()});
      } else {
        tell({MessageKind::Trouble, one.row.problems().front().sentence});
      }
    }
    const std::size_t wants = workers_.wants();
    if (!stopping_ && wants > asked_) rows.wants = wants - asked_;
    asked_ += rows.wants;
    if (!rows.rows.empty() || rows.wants > 0) tell(rows);
  }

  void obey(const std::optional<Order>& order) {
    if (!order || order->stop) {
      stopping_ = true;
      workers_.drop();
      return;
    }
    asked_ -= std::min(asked_, order->cells.size());
    workers_.give(order->cells);
  }

  Team& team_;
  const std::function<bool()>& interrupted_;
  Workers workers_;
  std::size_t asked_ = 0;  // cells asked for and not yet received
  bool stopping_ = false;
  bool told_interrupt_ = false;
};

}  // namespace

void follow(const Result<Sweep>& sweep, Team& team, int threads, const std::function<bool()>& interrupted) {
  if (sweep) {
    Follower(sweep.value(), team, threads, interrupted).run();
    return;
  }
  team.send(0, write(Report{MessageKind::Trouble, describe(sweep.problems().front())}));
  for (bool stopped = false; !stopped;) {
    const std::optional<Message> message = team.receive();
    stopped = message.has_value() && readOrder(message->text).value_or(Order{true}).stop;
    if (!message) std::this_thread::sleep_for(kLookAtLetters);
  }
  team.send(0, write(Report{MessageKind::Bye}));
}

}  // namespace underact::sweep
