#pragma once
#include <optional>
#include <string>

namespace underact::sweep {

/// A message from another rank.
struct Message {
  int from = 0;
  std::string text;
};

/// Processes that run one sweep together, each the same program with the same arguments. Letters between two ranks
/// arrive in the order in which they were sent. One thread of each process uses it.
class Team {
 public:
  virtual ~Team() = default;
  virtual int rank() const = 0;  // from 0, who leads
  /// How many ranks there are, this one included.
  virtual int size() const = 0;
  /// Sends a letter; returns at once.
  virtual void send(int to, const std::string& text) = 0;
  /// The next letter, if one has arrived.
  virtual std::optional<Message> receive() = 0;
};

}  // namespace underact::sweep
