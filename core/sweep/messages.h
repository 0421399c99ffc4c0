#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace underact::sweep {

// The contents of the letters between the leader and the other ranks.

/// From a rank to the leader. Hello: the first one, with the fingerprint of its sweep. Done: finished cells, and how
/// many more it wants. Trouble: why it cannot continue. Interrupted: it was asked to end. Bye: the last one, after
/// Stop.
enum class MessageKind { Hello, Done, Trouble, Interrupted, Bye };
/// A letter from a rank.
struct Report {
  /// A cell that is done, and its row of the journal.
  struct Line {
    std::size_t cell = 0;
    std::string row;
  };
  MessageKind word = MessageKind::Hello;
  std::string text = {};  // of Hello and Trouble
  std::size_t wants = 0;  // of Done
  std::vector<Line> rows = {};
};

/// From the leader to a rank: cells to run, or none and to stop.
struct Order {
  bool stop = false;
  std::vector<std::size_t> cells = {};
};

// The text of a letter, which the two functions below read back.
std::string write(const Report& report);
std::string write(const Order& order);
/// None: it is no such letter.
std::optional<Report> readReport(const std::string& message);
/// None: it is no such letter.
std::optional<Order> readOrder(const std::string& message);

}  // namespace underact::sweep
