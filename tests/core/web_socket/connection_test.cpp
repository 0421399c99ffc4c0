#include "core/web_socket/connection.h"

#include <gtest/gtest.h>

namespace underact::web_socket {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Milliseconds kLong{10000};

/// Two ends in one loop: who was accepted, and who connects.
struct Ends {
  explicit Ends(const Limits& theirs = {}, const Limits& own = {}) {
    EXPECT_EQ(listener.open(0), "");
    listener.accept([&](std::optional<Connection> one) {
      accepted = std::move(one);
      accepted->limit(theirs);
    });
    client.limit(own);
    std::optional<bool> connected;
    client.connect("127.0.0.1", listener.port(), [&](bool is_done) { connected = is_done; });
    runUntil([&] { return connected && accepted; });
    EXPECT_EQ(connected, true);
  }
  /// As WebSockets.
  void shakeHands() {
    std::optional<bool> ours, theirs;
    client.handshake("here:1", [&](bool is_done) { ours = is_done; });
    accepted->readHeader([&](bool is_read) {
      ASSERT_TRUE(is_read);
      EXPECT_TRUE(accepted->request().is_upgrade);
      accepted->accept([&](bool is_done) { theirs = is_done; });
    });
    runUntil([&] { return ours && theirs; });
    EXPECT_EQ(ours, true);
    EXPECT_EQ(theirs, true);
  }
  template <class Condition>
  void runUntil(const Condition& holds, Milliseconds time = kLong) {
    const Clock::time_point end = Clock::now() + time;
    while (!holds() && loop.runOneUntil(end)) continue;
  }
  /// What reader gets, "(text)" after it where it is one; "-": the connection is of no more use.
  std::string read(Connection& reader) {
    std::optional<std::string> got;
    reader.read([&](bool is_done, std::string_view message, bool is_text) {
      got = is_done ? std::string(message) + (is_text ? "(text)" : "") : "-";
    });
    runUntil([&] { return got.has_value(); });
    return got.value_or("?");
  }

  EventLoop loop;
  Listener listener{loop};
  std::optional<Connection> accepted;
  Connection client{loop};
};

void ignore(bool) {}

}  // namespace

TEST(Connection, TheMessagesOfBothSidesArriveInOrderAndAsWhatTheyWereSent) {
  Ends ends;
  ends.shakeHands();
  const std::string longest(100000, 'x');  // more than Beast's own buffer
  ends.client.write("one", false, ignore);
  EXPECT_EQ(ends.read(*ends.accepted), "one(text)");
  ends.client.write(longest, false, ignore);
  EXPECT_EQ(ends.read(*ends.accepted), longest + "(text)");
  ends.accepted->write({"\0\1", 2}, true, ignore);
  EXPECT_EQ(ends.read(ends.client), std::string({"\0\1", 2}));
}

TEST(Connection, AMessageAboveTheLimitEndsIt) {
  Ends ends({.message_bytes = 4});
  ends.shakeHands();
  ends.client.write("1234", false, ignore);
  EXPECT_EQ(ends.read(*ends.accepted), "1234(text)");
  ends.client.read([](bool, std::string_view, bool) {});  // is told why
  ends.client.write("12345", false, ignore);
  EXPECT_EQ(ends.read(*ends.accepted), "-");
}

TEST(Connection, WhoIsToldGoodbyeReadsNoMoreAndTheOtherLearnsThatItWasHeard) {
  Ends ends;
  ends.shakeHands();
  std::optional<bool> closed;
  ends.client.close(kNormalEnd, [&](bool is_done) { closed = is_done; });
  EXPECT_EQ(ends.read(*ends.accepted), "-");
  ends.runUntil([&] { return closed.has_value(); });
  EXPECT_EQ(closed, true);
}

TEST(Connection, WhoSaysNothingIsGivenUpWhenThePatienceIsOver) {
  Ends ends({.patience = Milliseconds(50)});
  std::optional<bool> read;
  ends.accepted->readHeader([&](bool is_done) { read = is_done; });
  ends.runUntil([&] { return read.has_value(); });
  EXPECT_EQ(read, false);
}

TEST(Connection, OfTwoSilentClientsTheOneThatAnswersPingsIsKept) {  // within half a second, on a busy machine, too
  for (const bool answers : {true, false}) {
    Ends ends({.patience = kLong, .silence = Milliseconds(1000)});
    ends.shakeHands();
    std::optional<bool> read;
    ends.accepted->read([&](bool is_done, std::string_view, bool) { read = is_done; });
    if (answers) ends.client.read([](bool, std::string_view, bool) {});  // only who reads can
    ends.runUntil([&] { return read.has_value(); }, answers ? Milliseconds(2500) : kLong);
    EXPECT_EQ(read, answers ? std::nullopt : std::optional(false));
  }
}

TEST(Connection, OverPlainHttpTheRequestArrivesAndTheBodyOfTheAnswerComesBack) {
  for (const int status : {200, 404}) {
    Ends ends;
    std::optional<std::string> body = "none yet";
    ends.client.get("here:1", "/devices?session=1", [&](std::optional<std::string> came) { body = std::move(came); });
    ends.accepted->readHeader([&](bool) {
      ends.accepted->readBody([&](bool is_read) {
        ASSERT_TRUE(is_read);
        const Request request = ends.accepted->request();
        EXPECT_EQ(request.method, "GET");
        EXPECT_EQ(request.target, "/devices?session=1");
        EXPECT_EQ(request.origin, std::nullopt);
        EXPECT_FALSE(request.is_upgrade);
        ends.accepted->respond(status, "application/json", "{}", [&](bool) { ends.accepted->end(); });
      });
    });
    ends.runUntil([&] { return body != "none yet"; });
    EXPECT_EQ(body, status == 200 ? std::optional<std::string>("{}") : std::nullopt);
  }
}

TEST(Connection, AHeaderAboveTheLimitIsRefused) {
  Ends ends({.header_bytes = 200});
  ends.client.get("here:1", "/" + std::string(300, 'x'), [](const std::optional<std::string>&) {});
  std::optional<bool> read;
  ends.accepted->readHeader([&](bool is_done) { read = is_done; });
  ends.runUntil([&] { return read.has_value(); });
  EXPECT_EQ(read, false);
}

TEST(Connection, WhereNobodyListensNoneIsMade) {
  Ends ends;
  const int port = ends.listener.port();
  ends.listener.close();
  Connection late(ends.loop);
  std::optional<bool> connected;
  late.connect("127.0.0.1", port, [&](bool is_done) { connected = is_done; });
  ends.runUntil([&] { return connected.has_value(); });
  EXPECT_EQ(connected, false);
}

TEST(Connection, WhatIsUnderWayWhenTheLoopEndsIsNeverCalled) {
  bool was_called = false;
  {
    Ends ends;
    ends.shakeHands();
    ends.client.read([&](bool, std::string_view, bool) { was_called = true; });
    ends.accepted->read([&](bool, std::string_view, bool) { was_called = true; });
  }
  EXPECT_FALSE(was_called);
}

}  // namespace underact::web_socket
