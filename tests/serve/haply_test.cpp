// The arm as clients of Haply's service see it, without a socket. Their own programs: tests/haply.
#include "app/serve/haply.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/serve/haply_state.h"
#include "core/json/value_text.h"
#include "core/record/replay.h"
#include "tests/serve/desk.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

/// A desk at which one sits who speaks Haply's language.
struct HaplyDesk : Desk {
  explicit HaplyDesk(const std::string& hand = "still") : Desk(false, hand), haply(*service) {
    host->start();
    run(200);
    client = haply.connect();
  }
  void tick(int ticks) {
    for (int one = 0; one < ticks; ++one) {
      run(1);
      haply.poll(now_s);
    }
  }
  void send(const std::string& text) { haply.receive(client, {text}, now_s); }
  std::vector<std::string> heard() {
    std::vector<std::string> messages;
    while (haply.hasMessage(client)) messages.push_back(haply.takeMessage(client).bytes);
    return messages;
  }
  void push(const Vec3& f_H, const char* key = "vector") {
    send(R"({"inverse3": [{"device_id": "0001", "commands": {"set_cursor_force": {")" + std::string(key) +
         R"(": {"x": )" + json::numberText(f_H.x()) + ", \"y\": " + json::numberText(f_H.y()) +
         ", \"z\": " + json::numberText(f_H.z()) + "}}}}]}");
  }
  Vec3 asked_N() { return service->lastTick().f_asked_T_W; }

  serve::HaplyService haply;
  int client = 0;
};

json::Value parsed(const std::string& text) {
  const Result<json::Value> root = json::parse(text, "");
  EXPECT_TRUE(root) << text;
  return root ? root.value() : json::Value();
}

const json::Value& at(const json::Value& root, std::initializer_list<const char*> keys) {
  static const json::Value kNothing;
  const json::Value* found = &root;
  for (const char* const key : keys) {
    if (found->kind == json::JsonKind::Array && !found->items.empty()) found = &found->items.front();
    found = found->find(key);
    if (found == nullptr) return kNothing;
  }
  return *found;
}

TEST(Haply, TheFirstMessageHasAllAndEachFrameIsAnsweredByOne) {
  HaplyDesk desk;
  desk.tick(3);
  std::vector<std::string> heard = desk.heard();
  ASSERT_EQ(heard.size(), 1U);
  const json::Value first = parsed(heard.front());
  EXPECT_EQ(at(first, {"inverse3", "device_id"}).text, "0001");
  EXPECT_EQ(at(first, {"inverse3", "config", "type"}).text, "inverse3");
  EXPECT_EQ(at(first, {"wireless_verse_grip", "state", "buttons", "a"}).kind, json::JsonKind::Bool);
  desk.tick(20);
  EXPECT_TRUE(desk.heard().empty()) << "nothing is sent to one that asks nothing";
  desk.send(R"({"inverse3": [{"device_id": "0001", "commands": {"probe_position": {}}}]})");
  EXPECT_TRUE(desk.heard().empty()) << "the state is that of the next tick";
  desk.tick(1);
  heard = desk.heard();
  ASSERT_EQ(heard.size(), 1U);
  const json::Value next = parsed(heard.front());
  EXPECT_EQ(at(next, {"inverse3", "config"}).kind, json::JsonKind::Null) << "only the changes";
  const Vec3 p_H = serve::haply::placeOf(desk.service->lastTick().p_WT);
  EXPECT_EQ(at(next, {"inverse3", "state", "cursor_position", "x"}).number, p_H.x());
  EXPECT_EQ(at(next, {"inverse3", "state", "cursor_position", "z"}).number, p_H.z());
  desk.send(R"({"session": {"force_render_full_state": {}, "configure": {"profile": {"name": "ball"}}}})");
  desk.tick(1);
  const json::Value full = parsed(desk.heard().front());
  EXPECT_EQ(at(full, {"inverse3", "config", "type"}).text, "inverse3");
  EXPECT_EQ(at(full, {"session", "config", "profile", "name"}).text, "ball");
}

TEST(Haply, ItsForceIsInItsAxesAndEndsAfter50Milliseconds) {
  for (const char* const key : {"vector", "values"}) {
    HaplyDesk desk;
    const Vec3 before_N = desk.asked_N();
    desk.push(Vec3(0.1, 0.2, 0.3), key);
    desk.tick(2);
    // Theirs: x right, y away, z up; W: x right, y up, z towards the person.
    EXPECT_LT((desk.asked_N() - before_N - Vec3(0.1, 0.3, -0.2)).norm(), 0.02) << "the hand gives a little";
    desk.tick(46);
    const Vec3 last_N = desk.asked_N();
    desk.tick(4);
    EXPECT_LT((last_N - desk.asked_N() - Vec3(0.1, 0.3, -0.2)).norm(), 0.1) << "it ends at once after 50 ms";
  }
}

TEST(Haply, HasTheFieldsOfTheirProtocol) {
  HaplyDesk desk("sweep");
  desk.tick(600);
  const Vec3 before = serve::haply::anglesOf(desk.service->lastTick());
  desk.tick(31);
  const json::Value full = parsed(desk.haply.answer({"GET", "/devices", {}}).body);
  EXPECT_EQ(at(full, {"inverse3", "config", "device_info", "device_type"}).number, 4.0);
  EXPECT_EQ(at(full, {"inverse3", "config", "streaming_mode"}).text, "USB");
  EXPECT_NE(at(full, {"inverse3", "config", "filters"}).find("damping"), nullptr);
  const json::Value& state = at(full, {"inverse3", "state"});
  for (const char* const key : {"current_cursor_position", "current_angular_torques", "current_angular_position"})
    EXPECT_NE(state.find(key), nullptr) << key;
  const Vec3 mean_deg_per_s = (serve::haply::anglesOf(desk.service->lastTick()) - before) / 0.031;
  EXPECT_NEAR(at(state, {"angular_velocity", "a1"}).number, mean_deg_per_s[1], 8.0);
  EXPECT_GT(std::abs(mean_deg_per_s[1]), 10.0);
}

TEST(Haply, TheTransformIsThatOfTheWorkspaceAndLeadsToTheClientsScene) {
  HaplyDesk desk;
  const auto part = [&](const char* device, const char* what, const char* axis) {
    return at(parsed(desk.haply.answer({"GET", "/devices", {}}).body), {device, "state", what, axis});
  };
  desk.tick(1);
  for (const char* const device : {"inverse3", "wireless_verse_grip"})
    EXPECT_EQ(json::textOf(part(device, "transform", "position")), R"({"x": 0, "y": 0, "z": 0})");
  const auto set = [&](const char* parts) {
    desk.send(R"({"inverse3": [{"commands": {"set_transform": {"transform": )" + std::string(parts) + "}}}]}");
  };
  set(R"({"rotation": {"x": 0, "y": 0, "z": 2, "w": 2}, "scale": {"x": 2, "y": 2, "z": 2}})");  // a quarter turn
  set(R"({"position": {"x": 1, "y": 0, "z": 0}})");  // what it leaves out stays
  const Vec3 before_N = desk.asked_N();
  desk.push(Vec3(0.0, 0.4, 0.0));
  desk.tick(2);
  EXPECT_NEAR(part("inverse3", "transform", "rotation").find("z")->number, std::sqrt(0.5), 1e-12);
  EXPECT_EQ(part("wireless_verse_grip", "transform", "rotation").find("z")->number, 0.0) << "it has its own";
  const double y_H = serve::haply::placeOf(desk.service->lastTick().p_WT).y();
  EXPECT_NEAR(part("inverse3", "cursor_position", "x").number, 1.0 - 2.0 * y_H, 1e-9);
  EXPECT_LT((desk.asked_N() - before_N - Vec3(0.4, 0.0, 0.0)).norm(), 0.02) << "away in its scene, to the right here";
  set(R"({"rotation": {"x": 0, "y": 0, "z": 0, "w": 0}})");
  EXPECT_NE(desk.heard().back().find("set_transform needs"), std::string::npos);
}

TEST(Haply, AForceThatIsNotToBeExecutedIsNot) {
  HaplyDesk desk;
  const Vec3 before_N = desk.asked_N();
  desk.send(R"({"inverse3": [{"device_id": "0001", "commands": {"set_cursor_force":
            {"vector": {"x": 0.5, "y": 0, "z": 0}, "execute": false}}}]})");
  desk.tick(3);
  EXPECT_LT((desk.asked_N() - before_N).norm(), 0.01);
}

TEST(Haply, ThereIsOneClientAndItsForceEndsWithIt) {
  HaplyDesk desk;
  const Vec3 before_N = desk.asked_N();
  const int second = desk.haply.connect();
  EXPECT_TRUE(desk.haply.closes(second));
  EXPECT_FALSE(desk.haply.closes(desk.client));
  desk.haply.disconnect(second);
  desk.push(Vec3(0.3, 0.0, 0.0));
  desk.tick(2);
  EXPECT_EQ(desk.service->steeringClient(), "haply");
  desk.haply.disconnect(desk.client);
  desk.tick(2);
  EXPECT_LT((desk.asked_N() - before_N).norm(), 0.1);
  EXPECT_EQ(desk.service->steeringClient(), "");
  EXPECT_FALSE(desk.haply.closes(desk.haply.connect()));
}

TEST(Haply, WhereAnotherClientSteersItOnlyListens) {
  HaplyDesk desk;
  const int other = desk.join("other");
  ASSERT_TRUE(Desk::isOk(desk.ask(other, R"({"id": 1, "do": "lease", "lease": "take"})")));
  const Vec3 before_N = desk.asked_N();
  desk.push(Vec3(0.5, 0.0, 0.0));
  desk.tick(2);
  EXPECT_LT((desk.asked_N() - before_N).norm(), 0.01);
  EXPECT_FALSE(desk.heard().empty()) << "the state is told all the same";
}

TEST(Haply, AnswersWhatItsClientsAskOverHttp) {
  HaplyDesk desk;
  const auto ask = [&](const std::string& method, const std::string& target, const std::string& body = {}) {
    return desk.haply.answer({method, target, body});
  };
  EXPECT_EQ(at(parsed(ask("GET", "/version").body), {"project_version"}).text, "3.5.0");
  EXPECT_EQ(at(parsed(ask("GET", "/devices?session=:-1").body), {"inverse3", "config", "device_info", "id"}).text,
            "0001");
  EXPECT_EQ(at(parsed(ask("GET", "/sessions").body), {"data", "session_count"}).number, 1.0);
  EXPECT_EQ(ask("POST", "/sessions/1/profile", R"({"name": "cube"})").status, 200);
  EXPECT_EQ(at(parsed(ask("GET", "/sessions/1/profile").body), {"data", "name"}).text, "cube");
  EXPECT_EQ(ask("POST", "/sessions/1/profile", "}}}").status, 400);
  const serve::HttpAnswer nothing = ask("GET", "/nothing");
  EXPECT_EQ(nothing.status, 404);
  EXPECT_FALSE(at(parsed(nothing.body), {"ok"}).boolean);
}

TEST(Haply, AnyFrameIsAnsweredAndNoneMakesAForceThatIsNotFinite) {
  HaplyDesk desk("tremor");
  const std::string good =
      R"({"session": {}, "inverse3": [{"device_id": "0001", "commands": {"set_cursor_force": {"vector": {"x": 0.1, "y": 1e400, "z": 0}}}}]})";
  Random random(Seed{35});
  for (int frame = 0; frame < sweep(3000, 100000); ++frame) {
    std::string text = good;
    for (std::uint64_t times = random.below(4); times > 0; --times)
      text[random.below(text.size())] = static_cast<char>(random.below(256));
    desk.send(text.substr(0, random.below(2) == 0 ? text.size() : random.below(text.size())));
    desk.tick(1);
    ASSERT_TRUE(desk.asked_N().allFinite());
    EXPECT_LE(desk.heard().size(), 2U);
  }
}

TEST(Haply, ItsSessionReplaysToTheBit) {
  HaplyDesk desk("tremor");
  const std::string path = desk.folder.path() + "/haply.h5";
  ASSERT_TRUE(desk.alone->startRecordingAt(path, system::Existing::Refuse).empty());
  Random random(Seed{36});
  for (int frame = 0; frame < 200; ++frame) {
    desk.push(Vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
    desk.tick(1 + static_cast<int>(random.below(80)));
  }
  desk.host->endRecord();
  desk.host->run(1);
  ASSERT_TRUE(desk.alone->close().empty());
  Result<record::Session> session = record::Session::open(path);
  ASSERT_TRUE(session);
  const Result<record::Verified> verified = record::verifyReplay(session.value());
  ASSERT_TRUE(verified);
  EXPECT_FALSE(verified.value().differs);
  EXPECT_GT(verified.value().ticks, 200);
}

}  // namespace
}  // namespace underact::test
