#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/serve/host_alone.h"
#include "app/serve/service.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "tests/serve/schema.h"
#include "tests/session/rig.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

inline constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

/// A service on the simulated arm, whose ticks are run by hand; each message of it is checked by the schema.
class Desk {
 public:
  explicit Desk(bool anyone_steers = false, const std::string& hand = "still", std::uint64_t seed = 1)
      : host(makeHost(servo::Clock::Manual, hand, 1000, seed)) {
    EXPECT_TRUE(host->load(sphereScene()).empty());
    alone = std::make_unique<serve::HostAlone>(*host, serve::HostAloneOptions{folder.path() + "/sessions"});
    service = std::make_unique<serve::Service>(*alone, serve::ServiceOptions{kToken, anyone_steers});
    run(1);
  }

  /// Runs ticks as the server does: the service looks after each millisecond of them.
  void run(int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      host->run(1);
      now_s += 0.001;
      service->poll(now_s);
    }
  }
  int connect() { return service->connect(); }
  /// A client that has said hello.
  int join(const std::string& name) {
    const int client = connect();
    const std::string answer =
        ask(client, R"({"id": 0, "do": "hello", "token": ")" + std::string(kToken) + R"(", "name": ")" + name + "\"}");
    EXPECT_TRUE(isOk(answer)) << answer;
    return client;
  }
  void send(int client, const std::string& text) { service->receive(client, {text, true, host->stops()}, now_s); }
  /// All that waits for it.
  std::vector<std::string> take(int client) {
    std::vector<std::string> messages;
    while (service->hasMessage(client)) {
      const serve::Message message = service->takeMessage(client);
      messages.push_back(message.bytes);
      if (message.is_binary) continue;
      const bool is_answer = message.bytes.starts_with("{\"id\"");
      std::string text = message.bytes;  // a number as id may be beyond the double of the schema's reader
      if (is_answer && text[7] < ':' && text[7] != '"') text.replace(7, text.find(',') - 7, "1");
      EXPECT_TRUE((is_answer ? answers_ : pushes_).accepts(text)) << message.bytes;
    }
    return messages;
  }
  /// The answer, with ticks run until it is there; the pushes before it are dropped.
  std::string ask(int client, const std::string& text) {
    send(client, text);
    for (int tick = 0; tick < 3000; ++tick) {
      for (const std::string& message : take(client)) {
        if (message.starts_with("{\"id\"")) return message;
      }
      run(1);
      if (tick > 300) std::this_thread::sleep_for(std::chrono::milliseconds(5));  // a worker reads
    }
    return "no answer to " + text;
  }
  static bool isOk(const std::string& answer) { return answer.find("\"ok\": true") != std::string::npos; }
  /// The number of a key in an answer.
  static double number(const std::string& answer, const char* key) {
    const Result<json::Value> root = json::parse(answer, "");
    const json::Value* const value = root ? root.value().find(key) : nullptr;
    EXPECT_TRUE(value != nullptr && value->kind == json::JsonKind::Number) << key << " of " << answer;
    return value != nullptr ? value->number : 0.0;
  }
  bool isRequest(const std::string& text) const { return requests_.accepts(text); }

  ScratchFolder folder;
  std::unique_ptr<servo::Host> host;
  std::unique_ptr<serve::HostAlone> alone;
  std::unique_ptr<serve::Service> service;
  double now_s = 1.0;

 private:
  Schema requests_{"request"}, answers_{"answer"}, pushes_{"push"};
};

}  // namespace underact::test
