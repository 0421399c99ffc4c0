// What a stranger can make the service do is bounded. Steps and sizes are counted; times are measured by the soak.
#include <filesystem>

#include "app/serve/request.h"
#include "tests/serve/desk.h"
#include "tests/support/comes.h"

namespace underact::test {
namespace {

std::size_t timesOf(const std::string& words, const std::string& text) {
  std::size_t times = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++times;
  return times;
}

std::ptrdiff_t threadsOfThisProcess() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

/// A request whose list or object has so many members, with numbers for "#".
std::string requestOf(const std::string& begin, const std::string& member, int count, const std::string& end) {
  std::string text = begin;
  for (int index = 0; index < count; ++index) {
    std::string one = member;
    one.replace(one.find('#'), 1, std::to_string(index));
    text += (index > 0 ? ", " : "") + one;
  }
  return text + end;
}

TEST(LiveServiceBounds, ThousandsOfUnknownPathsComeToAHundredProblemsOfWhichTenNameTheNearest) {
  Desk desk;
  const int client = desk.join("lab");
  const std::string set = R"({"id": 1, "do": "set", "values": {)", get = R"({"id": 1, "do": "get", "paths": [)";
  for (const std::string& request :
       {requestOf(set, R"("/control/kp_N_per_m#": 1)", 4000, "}}"),
        requestOf(get, R"("/control/kp_N_per_m#")", 5000, "]}"), requestOf(get, R"("/control/kp_N_per_m#")", 500, "]}"),
        requestOf(R"({"id": 1, "do": "subscribe", "hz": 1, "columns": [)", R"("p_WT_m#")", 1000, "]}")}) {
    const std::string answer = desk.ask(client, request);
    EXPECT_EQ(timesOf("\"sentence\"", answer), 100U) << request.substr(0, 30);
    EXPECT_EQ(timesOf("Did you mean", answer), 10U) << request.substr(0, 30);
  }
  for (const std::string& request :
       {requestOf(set, R"("/some/key/with/a/long/name/that/nothing/has/#": 1)", 14000, "}}"),
        requestOf(get, R"("/control/#")", 10000, "]}")})
    EXPECT_NE(desk.ask(client, request).find("These are too many"), std::string::npos) << request.substr(0, 30);
}

TEST(LiveServiceBounds, TheWayToAProblemIsCutAndWrittenForProblemsAlone) {
  Desk desk;
  const int client = desk.join("lab");
  // Where each of the 40 000 ways were written, they would be 20 GB.
  const std::string answer =
      desk.ask(client, requestOf(R"({"id": 1, "do": "set", "values": {")" + std::string(500'000, 'k') + R"(": [)",
                                 "1e999, #", 40000, "]}}"));
  EXPECT_EQ(timesOf("too large", answer), 100U);
  EXPECT_LT(answer.size(), 100'000U);
}

TEST(LiveServiceBounds, ALongRequestIsReadByAWorkerWhileOthersAreAnswered) {
  Desk desk;
  const int client = desk.join("lab"), other = desk.join("other");
  desk.send(client, R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": 0.3}, "pad": ")" +
                        std::string(900'000, ' ') + "\"}");
  EXPECT_FALSE(desk.service->hasMessage(client)) << "nothing of it is read at once";
  EXPECT_TRUE(Desk::isOk(desk.ask(other, R"({"id": 2, "do": "status"})")));
  EXPECT_NE(desk.ask(client, R"({"id": 3, "do": "status"})").find("\"/pad\""), std::string::npos) << "in its order";
  const std::string well =
      desk.ask(client, R"({"id": 4, "do": "set", "values": {"/control/kp_N_per_mm": 0.3}})" + std::string(20'000, ' '));
  EXPECT_TRUE(Desk::isOk(well)) << well;
  EXPECT_EQ(desk.host->scene().control.gains.kp_N_per_mm, Vec3(Vec3::Constant(0.3)));
  const std::string mark = desk.ask(client, R"({"id": 5, "do": "mark", "text": "a"})" + std::string(20'000, ' '));
  EXPECT_NE(mark.find("more than 16384 bytes"), std::string::npos) << mark;
}

TEST(LiveServiceBounds, LoadsOfClientsThatHaveLeftMakeNoThreadsAndAreDropped) {
  Desk desk;
  const std::uint64_t revision = desk.host->revision();
  const std::ptrdiff_t threads = threadsOfThisProcess();
  for (int number = 0; number < 400; ++number) {
    const int client = desk.join("one");
    desk.send(client, R"({"id": 1, "do": "load", "file": "14_circle_influence"})");
    desk.service->disconnect(client);
    EXPECT_LE(threadsOfThisProcess(), threads + 1);
  }
  EXPECT_FALSE(desk.service->isBusy()) << "none of them waits";
  desk.run(300);
  EXPECT_EQ(desk.host->revision(), revision);
}

TEST(LiveServiceBounds, OfRequestsBehindALoadAHundredWaitAndStopDoesNot) {
  Desk desk;
  const int client = desk.join("lab");
  ASSERT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 1, "do": "start"})")));
  desk.send(client, R"({"id": 2, "do": "load", "file": "14_circle_influence"})");
  desk.send(client, R"({"id": "again", "do": "start"})");
  for (int index = 0; index < 150; ++index) desk.send(client, R"({"id": "later", "do": "status"})");
  EXPECT_TRUE(desk.service->mayBeRead(client)) << "else its stop would not be heard";
  desk.send(client, R"({"id": 3, "do": "stop"})");
  EXPECT_FALSE(desk.host->running());
  std::string all;
  ASSERT_TRUE(comes([&] {
    desk.run(1);
    for (const std::string& message : desk.take(client)) all += message;
    return timesOf("\"id\": \"later\"", all) == 150;
  }));
  EXPECT_EQ(timesOf("Too many requests wait", all), 51U) << "the start waits, too";
  EXPECT_EQ(timesOf("was stopped after this request had come", all), 1U);
  EXPECT_FALSE(desk.host->running());
}

TEST(LiveServiceBounds, AGlanceSeesIdAndNameAtTheTopOfTheFirstBytesAlone) {
  const struct {
    std::string text;
    const char* id;
    const char* what;
  } cases[] = {
      {R"({"id": 7, "do": "stop"})", "7", "stop"},
      {R"( { "do" : "st\u006fp" , "more": [1, {"id": 3}], "id" : "a\"b" })", R"("a\"b")", "stop"},
      {R"({"values": {"do": "stop", "id": 1}, "do": "set"})", "null", "set"},
      {R"({"id": [1], "do": ["stop"]})", "null", ""},
      {R"({"id": 1, "do": "sto)", "1", ""},
      {R"(["do", "stop"])", "null", ""},
      {R"({"text": "\", \"do\": \"stop\"", "do": "mark", "do": "stop"})", "null", "mark"},
      {R"({"id": ")" + std::string(300, 'a') + R"(", "do": "stop"})", "null", "stop"},
      {R"({"pad": ")" + std::string(5000, ' ') + R"(", "do": "stop"})", "null", ""},
      {R"({"id": true, "do": "stop")" + std::string(5000, '['), "true", "stop"},
      {"", "null", ""},
      {std::string(5000, '}'), "null", ""},
  };
  for (const auto& [text, id, what] : cases) {
    const serve::Glance glance = serve::glanceAt(text);
    EXPECT_EQ(glance.id, id) << text.substr(0, 80);
    EXPECT_EQ(glance.what, what) << text.substr(0, 80);
  }
}

TEST(Challenge, IsAnsweredOnceBeforeHelloByWhoKnowsTheToken) {
  Desk desk;
  const auto asked = [&](int client, const std::string& nonce, const char* given, bool closes) {
    const std::string text = R"({"id": 1, "do": "challenge", "nonce": ")" + nonce + "\"}";
    EXPECT_EQ(desk.isRequest(text), nonce.size() == 32 && nonce.back() == 'f');
    const std::string answer = desk.ask(client, text);
    EXPECT_NE(answer.find(given), std::string::npos) << nonce << ": " << answer;
    EXPECT_EQ(desk.service->closes(client), closes) << nonce;
  };
  const char* const nonce = "00112233445566778899aabbccddeeff";
  const int client = desk.connect();
  asked(client, nonce, "e2f18cb41fd0132236a07d04a640d4835d49aa14a1e3cadc7a6af79b13bd33bb", false);  // Python's hmac
  asked(client, nonce, "comes once", true);
  asked(desk.join("lab"), nonce, "comes once", false);
  for (const char* const wrong : {"00", "0011223344556677889900112233445g", ""})
    asked(desk.connect(), wrong, "/nonce", true);
}

}  // namespace
}  // namespace underact::test
