#include "core/sweep/lead.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/sweep/messages.h"
#include "core/sweep/workers.h"

namespace underact::sweep {
namespace {

constexpr std::chrono::microseconds kLookAround{200'000};

/// A running sweep, as seen by the leader.
class Leader {
 public:
  Leader(const Sweep& sweep, Journal& journal, Team* team, int threads, const Watcher& watcher)
      : sweep_(sweep), journal_(journal), team_(team), watcher_(watcher), workers_(sweep, threads) {
    wanted_.resize(team == nullptr ? 1 : static_cast<std::size_t>(team->size()));
    others_ = wanted_.size() - 1;
    for (std::size_t cell = sweep.cells.count; cell-- > 0;) {
      if (!journal.rows().contains(cell)) open_.push_back(cell);
    }
  }

  Outcome run() {
    while (!stopping_ || workers_.held() > 0 || others_ > 0) {
      wanted_[0] = workers_.wants();
      handOut();
      for (const Finished& finished : workers_.take(team_ == nullptr ? kLookAround : kLookAtLetters)) {
        if (finished.row)
          keep(finished.cell, finished.row.value());
        else
          fail(finished.row.problems());
      }
      readLetters();
      if (!stopping_ && watcher_.interrupted()) interrupt();
      if (!stopping_ && journal_.rows().size() == sweep_.cells.count) stop();
      watcher_.progress(journal_.rows().size());
    }
    return outcome_;
  }

 private:
  /// Gives the next cells to those who want some: one each in turn, so that the last ones are distributed.
  void handOut() {
    std::vector<std::vector<std::size_t>> shares(wanted_.size());
    bool gave = true;
    while (gave && !open_.empty()) {
      gave = false;
      for (std::size_t rank = 0; rank < shares.size() && !open_.empty(); ++rank) {
        if (wanted_[rank] == 0) continue;
        shares[rank].push_back(open_.back());
        open_.pop_back();
        --wanted_[rank];
        gave = true;
      }
    }
    workers_.give(shares[0]);
    for (std::size_t rank = 1; rank < shares.size(); ++rank) {
      if (!shares[rank].empty()) team_->send(static_cast<int>(rank), write(Order{false, std::move(shares[rank])}));
    }
  }

  void readLetters() {
    if (team_ == nullptr) return;
    while (const std::optional<Message> message = team_->receive()) {
      const std::optional<Report> report = readReport(message->text);
      if (report) {
        hear(message->from, *report);
      } else {
        fail({{rankOf(message->from) + " wrote something that is not a message of a sweep."}});
      }
    }
  }

  void hear(int from, const Report& report) {
    switch (report.word) {
      case MessageKind::Hello:
        if (report.text != sweep_.fingerprint)
          fail({{rankOf(from) + " runs another build of the program, or sees other files or options."}});
        break;
      case MessageKind::Done:
        wanted_[static_cast<std::size_t>(from)] += report.wants;
        for (const Report::Line& line : report.rows) {
          if (line.cell < sweep_.cells.count) keep(line.cell, line.row);
        }
        break;
      case MessageKind::Trouble:
        fail({{rankOf(from) + ": " + report.text}});
        break;
      case MessageKind::Interrupted:
        if (!stopping_) interrupt();
        break;
      case MessageKind::Bye:
        --others_;
        break;
    }
  }

  static std::string rankOf(int rank) { return "Rank " + std::to_string(rank); }

  void keep(std::size_t cell, const std::string& row) {
    if (!is_full_) {
      Problems problems = journal_.add(cell, row);
      is_full_ = !problems.empty();
      if (is_full_) fail(std::move(problems));
    }
  }

  void fail(Problems problems) {
    // The first problem is the reason; later ones mostly follow from it.
    if (outcome_.problems.empty()) outcome_.problems = std::move(problems);
    if (!stopping_) stop();
  }

  void interrupt() {
    outcome_.interrupted = true;
    stop();
  }

  void stop() {
    stopping_ = true;
    open_.clear();
    workers_.drop();
    for (std::size_t rank = 1; rank < wanted_.size(); ++rank) team_->send(static_cast<int>(rank), write(Order{true}));
  }

  const Sweep& sweep_;
  Journal& journal_;
  Team* team_;
  const Watcher& watcher_;
  Workers workers_;
  std::vector<std::size_t> open_;    // the next one last
  std::vector<std::size_t> wanted_;  // by rank: cells it asked for and has not received
  std::size_t others_ = 0;           // that have not said goodbye
  bool stopping_ = false;
  bool is_full_ = false;
  Outcome outcome_;
};

}  // namespace

Outcome lead(const Sweep& sweep, Journal& journal, Team* team, int threads, const Watcher& watcher) {
  return Leader(sweep, journal, team, threads, watcher).run();
}

void dismiss(Team& team) {
  for (int rank = 1; rank < team.size(); ++rank) team.send(rank, write(Order{true}));
  for (int left = team.size() - 1; left > 0;) {
    const std::optional<Message> message = team.receive();
    if (!message) {
      std::this_thread::sleep_for(kLookAtLetters);
      continue;
    }
    const std::optional<Report> report = readReport(message->text);
    if (report && report->word == MessageKind::Bye) --left;
  }
}

}  // namespace underact::sweep
