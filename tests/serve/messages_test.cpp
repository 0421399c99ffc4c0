// Every request, and every wrong one.
#include <chrono>
#include <cstring>
#include <thread>

#include "core/record/session.h"
#include "tests/serve/desk.h"

namespace underact::test {
namespace {

using testing::Test;

std::string hello(const std::string& token = kToken) {
  return R"({"id": 1, "do": "hello", "token": ")" + token + R"(", "name": "lab"})";
}

TEST(LiveService, AnswersEachRequestAsTheSchemaSays) {
  Desk desk;
  const int client = desk.connect();
  const std::vector<std::string> all{
      hello(),
      R"({"id": "two", "do": "scene"})",
      R"({"id": true, "do": "settings"})",
      R"({"id": 1.5, "do": "get", "paths": ["/control/kp_N_per_mm", "/control/law", "/constraints/0/side"]})",
      R"({"id": 2, "do": "set", "values": {"/control/kp_N_per_mm": 0.3}})",
      R"({"id": 3, "do": "set", "values": {"/control/kp_N_per_mm": [0.3, 0.3, 0.2], "/control/law": "PD", "/control/anisotropy": "euclidean"}})",
      R"({"id": 4, "do": "start"})",
      R"({"id": 5, "do": "force", "f_N": [0.1, 0, -0.2], "for_ms": 20})",
      R"({"id": 6, "do": "force", "f_N": [0, 0, 0]})",
      R"({"id": 7, "do": "mark", "text": "trial 1"})",
      R"({"id": 8, "do": "record", "file": "trial.h5"})",
      R"({"id": 9, "do": "record", "stop": true})",
      R"({"id": 10, "do": "subscribe", "columns": ["p_WT_mm", "fault"], "hz": 100, "format": "json"})",
      R"({"id": 11, "do": "subscribe", "columns": [], "hz": 1000, "format": "binary"})",
      R"({"id": 12, "do": "unsubscribe"})",
      R"({"id": 13, "do": "status"})",
      R"({"id": 14, "do": "lease", "lease": "give"})",
      R"({"id": 15, "do": "lease", "lease": "take"})",
      R"({"id": 16, "do": "constraint.add", "constraint": {"name": "wall", "type": "plane", "side": "outside", "point_mm": [0, -10, 0], "normal": [0, 1, 0]}})",
      R"({"id": 17, "do": "constraint.move", "name": "wall", "values": {"point_mm": [0, -5, 0]}})",
      R"({"id": 18, "do": "constraint.move", "name": "wall", "values": {"point_mm": [0, -8, 0], "normal": [0, 1, 0.1]}, "over_ms": 10})",
      R"({"id": 19, "do": "constraint.remove", "name": "wall"})",
      R"({"id": 20, "do": "load", "scene": {"underact_scene": 1, "title": "One", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]}})",
      R"({"id": 21, "do": "load", "file": "14_circle_influence"})",
      R"({"id": 22, "do": "stop"})"};
  for (const std::string& request : all) {
    EXPECT_TRUE(desk.isRequest(request)) << request;
    const std::string answer = desk.ask(client, request);
    EXPECT_TRUE(Desk::isOk(answer)) << request << "\n" << answer;
  }
}

struct Wrong {
  const char* request;
  const char* path;
  const char* words;         // of the sentence
  bool is_of_schema = true;  // the schema refuses it, too
};

const Wrong kWrong[] = {
    {R"({"id": 1, "do": "fly"})", "/do", "There is no request"},
    {R"({"id": 1, "do": "stat"})", "/do", "Did you mean"},
    {R"({"id": 1, "do": 7})", "/do", "name of a request"},
    {R"({"do": "status"})", "/id", "missing"},
    {R"({"id": [1], "do": "status"})", "/id", "number"},
    {R"({"id": null, "do": "status"})", "/id", "null is never a value"},
    {R"({"id": 1, "do": "status", "more": 1})", "/more", "not known"},
    {R"({"id": 1, "id": 2, "do": "status"})", "/id", "twice", false},
    {R"({"id": 1, "do": "hello", "token": "x", "name": "y"})", "/do", "already", false},
    {R"({"id": 1, "do": "load"})", "/scene", "Give the scene"},
    {R"({"id": 1, "do": "load", "scene": {}, "file": "x"})", "/scene", "not both"},
    {R"({"id": 1, "do": "load", "scene": {}})", "/scene/title", "missing", false},
    {R"({"id": 1, "do": "load", "scene": 3})", "/scene", "object"},
    {R"({"id": 1, "do": "load", "file": "no_such_scene"})", "/file", "No scene of this name", false},
    {R"({"id": 1, "do": "load", "file": "scenes/x.json"})", "/file", "must be absolute", false},
    {R"({"id": 1, "do": "load", "scene": {"underact_scene": 1, "title": "a", "constraints": [{"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": -1}]}})",
     "/scene/constraints/0/radius_mm", "above 0", false},
    {R"({"id": 1, "do": "load", "scene": {"underact_scene": 1, "title": "a", "arm": "phantom-3-0", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]}})",
     "/scene/arm", "", false},
    {R"({"id": 1, "do": "get"})", "/paths", "missing"},
    {R"({"id": 1, "do": "get", "paths": [3]})", "/paths/0", "path of a setting"},
    {R"({"id": 1, "do": "get", "paths": ["/control/kp"]})", "/control/kp", "Did you mean", false},
    {R"({"id": 1, "do": "get", "paths": ["/constraints/0/influence/t"]})", "/constraints/0/influence/t", "no value now",
     false},
    {R"({"id": 1, "do": "get", "paths": ["/constraints/9/side"]})", "/constraints/9/side", "has 1 constraints", false},
    {R"({"id": 1, "do": "set", "values": {}})", "/values", "at least"},
    {R"({"id": 1, "do": "set", "values": [1]})", "/values", "object"},
    {R"({"id": 1, "do": "set", "values": {"/nowhere": 1}})", "/nowhere", "no setting", false},
    {R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": null}})", "/values/~1control~1kp_N_per_mm",
     "never a value"},
    {R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": 1e999}})", "/values/~1control~1kp_N_per_mm",
     "too large"},
    {R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": "soft"}})", "/control/kp_N_per_mm", "number", false},
    {R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": -1}})", "/control/kp_N_per_mm", "", false},
    {R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": [1, 2]}})", "/control/kp_N_per_mm", "", true},
    {R"({"id": 1, "do": "set", "values": {"/control/law": "PDX"}})", "/control/law", "must be", false},
    {R"({"id": 1, "do": "set", "values": {"/constraints/0/friction/dynamic": 0.5}})", "/constraints/0/friction/dynamic",
     "", false},
    {R"({"id": 1, "do": "set", "values": {"/constraints/0/search": "local"}})", "/constraints/0/search",
     "nothing there", false},
    {R"({"id": 1, "do": "set", "values": {"/constraints/00/side": "outside"}})", "/constraints/00/side", "no setting",
     false},
    {R"({"id": 1, "do": "force"})", "/f_N", "missing"},
    {R"({"id": 1, "do": "force", "f_N": [1, 2]})", "/f_N", "list of 3"},
    {R"({"id": 1, "do": "force", "f_N": [1, 2, "3"]})", "/f_N", "list of 3"},
    {R"({"id": 1, "do": "force", "f_N": [1e7, 0, 0]})", "/f_N", "1e6", false},
    {R"({"id": 1, "do": "force", "f_N": [0, 0, 1e999]})", "/f_N/2", "too large"},
    {R"({"id": 1, "do": "force", "f_N": [0, 0, 0], "for_ms": 0})", "/for_ms", "from 1 to 1000"},
    {R"({"id": 1, "do": "force", "f_N": [0, 0, 0], "for_ms": 1001})", "/for_ms", "from 1 to 1000"},
    {R"({"id": 1, "do": "mark"})", "/text", "missing"},
    {R"({"id": 1, "do": "mark", "text": 5})", "/text", "text"},
    {R"({"id": 1, "do": "record"})", "/file", "missing"},
    {R"({"id": 1, "do": "record", "file": "../away.h5"})", "/file", "sessions folder"},
    {R"({"id": 1, "do": "record", "file": ".hidden.h5"})", "/file", "sessions folder"},
    {R"({"id": 1, "do": "record", "file": "trial.txt"})", "/file", "sessions folder"},
    {R"({"id": 1, "do": "record", "stop": true})", "/stop", "Nothing is being recorded", false},
    {R"({"id": 1, "do": "record", "stop": false})", "/stop", "must be true"},
    {R"({"id": 1, "do": "subscribe", "columns": ["p_WT_m"], "hz": 100})", "/columns/0", "Did you mean", false},
    {R"({"id": 1, "do": "subscribe", "columns": ["tick", "tick"], "hz": 100})", "/columns/1", "twice", false},
    {R"({"id": 1, "do": "subscribe", "columns": [1], "hz": 100})", "/columns/0", "name of a column"},
    {R"({"id": 1, "do": "subscribe", "columns": [], "hz": 0.5})", "/hz", "from 1 to 1000"},
    {R"({"id": 1, "do": "subscribe", "columns": [], "hz": 2000})", "/hz", "from 1 to 1000", false},
    {R"({"id": 1, "do": "subscribe", "columns": [], "hz": 10, "format": "xml"})", "/format", "binary"},
    {R"({"id": 1, "do": "lease", "lease": "steal"})", "/lease", "take"},
    {R"({"id": 1, "do": "constraint.add", "constraint": {"type": "sphere", "center_mm": [0, 0, 0]}})",
     "/constraint/radius_mm", "missing", false},
    {R"({"id": 1, "do": "constraint.add", "constraint": {"type": "cone"}})", "/constraint/type", "", false},
    {R"({"id": 1, "do": "constraint.add", "constraint": {"name": "ball", "type": "point", "position_mm": [0, 0, 0]}})",
     "/constraint/name", "already", false},
    {R"({"id": 1, "do": "constraint.remove", "name": "nobody"})", "/name", "no constraint", false},
    {R"({"id": 1, "do": "constraint.remove", "name": "ball"})", "/name", "only constraint", false},
    {R"({"id": 1, "do": "constraint.move", "name": "nobody", "values": {"radius_mm": 3}})", "/name", "no constraint",
     false},
    {R"({"id": 1, "do": "constraint.move", "name": "ball", "values": {}})", "/values", "at least"},
    {R"({"id": 1, "do": "constraint.move", "name": "ball", "values": {"side": "outside"}})", "/values/side", "set",
     false},
    {R"({"id": 1, "do": "constraint.move", "name": "ball", "values": {"radius_mm": 0}})", "/values/radius_mm",
     "above 0", false},
    {R"({"id": 1, "do": "constraint.move", "name": "ball", "values": {"axis": [0, 0, 1]}})", "/values/axis",
     "not known", false},
    {R"({"id": 1, "do": "constraint.move", "name": "ball", "values": {"radius_mm": 30}, "over_ms": -1})", "/over_ms",
     "from 0"},
};

TEST(LiveService, RefusesEachWrongRequestWithASentenceAndItsPathAndChangesNothing) {
  Desk desk;
  const int client = desk.join("lab");
  const std::uint64_t revision = desk.host->revision();
  for (const Wrong& wrong : kWrong) {
    EXPECT_EQ(desk.isRequest(wrong.request), !wrong.is_of_schema) << wrong.request;
    const std::string answer = desk.ask(client, wrong.request);
    EXPECT_FALSE(Desk::isOk(answer)) << wrong.request << "\n" << answer;
    const std::string path = std::string("\"path\": \"") + wrong.path + "\"";
    EXPECT_NE(answer.find(path), std::string::npos) << wrong.request << "\n" << answer;
    EXPECT_NE(answer.find(wrong.words), std::string::npos) << wrong.request << "\n" << answer;
  }
  EXPECT_EQ(desk.host->revision(), revision);
  EXPECT_FALSE(desk.service->closes(client));
}

TEST(LiveService, AnswersWithTheIdAsItCame) {
  Desk desk;
  const int client = desk.join("lab");
  const std::string digits(200, '7');
  for (const std::string id : {"9007199254740993", "-9223372036854775809", digits.c_str(), "1.0", "1", "-0", "1E5",
                               "1e400", "true", "\"9007199254740993\""}) {
    const std::string answer = desk.ask(client, R"({"do": "status", "id":)" + id + "}");
    EXPECT_TRUE(answer.starts_with("{\"id\": " + id + ", \"ok\": true")) << answer;
    EXPECT_EQ(serve::glanceAt("{\"id\": " + id + "}").id, id);
  }
  EXPECT_NE(desk.ask(client, "{\"id\": 7" + digits + R"(, "do": "status"})").find("at most 200"), std::string::npos);
}

TEST(LiveService, RefusesTextsThatAreTooLong) {
  Desk desk;
  const int client = desk.join("lab");
  const std::string mark = R"({"id": 1, "do": "mark", "text": ")" + std::string(1001, 'a') + "\"}";
  EXPECT_FALSE(desk.isRequest(mark));
  EXPECT_NE(desk.ask(client, mark).find("at most 1000 bytes"), std::string::npos);
  const std::string id = R"({"id": ")" + std::string(201, 'a') + R"(", "do": "status"})";
  EXPECT_FALSE(desk.isRequest(id));
  EXPECT_NE(desk.ask(client, id).find("\"id\": null"), std::string::npos);
}

TEST(LiveService, ClosesAfterAnythingElseThanHelloAndAfterAWrongToken) {
  Desk desk;
  for (const std::string& first :
       {std::string(R"({"id": 1, "do": "status"})"), hello("wrong"), hello(""), hello(std::string(kToken) + "0")}) {
    const int client = desk.connect();
    const std::string answer = desk.ask(client, first);
    EXPECT_FALSE(Desk::isOk(answer)) << first;
    EXPECT_TRUE(desk.service->closes(client)) << first;
    desk.send(client, hello());
    EXPECT_FALSE(desk.service->hasMessage(client)) << "it is not listened to any longer";
  }
}

TEST(LiveService, ClosesWithTheThirdFrameThatIsNoRequest) {
  Desk desk;
  const int client = desk.join("lab");
  for (const char* bad : {"{", "[1, 2]", R"({"id": 3})"}) {
    EXPECT_FALSE(desk.service->closes(client));
    const std::string answer = desk.ask(client, bad);
    EXPECT_NE(answer.find("\"id\": null"), std::string::npos) << answer;
  }
  EXPECT_TRUE(desk.service->closes(client));
}

TEST(LiveService, TakesNoBinaryFrame) {
  Desk desk;
  const int client = desk.join("lab");
  desk.service->receive(client, {R"({"id": 1, "do": "status"})", false}, desk.now_s);
  EXPECT_NE(desk.take(client).at(0).find("\"ok\": false"), std::string::npos);
}

TEST(LiveService, HasEightClientsAndTellsTheNinth) {
  Desk desk;
  for (int number = 0; number < 8; ++number) desk.join("client " + std::to_string(number));
  const int ninth = desk.connect();
  EXPECT_FALSE(Desk::isOk(desk.ask(ninth, hello())));
  EXPECT_TRUE(desk.service->closes(ninth));
}

TEST(LiveService, SetsAllValuesAtOneTickOrNone) {
  Desk desk;
  const int client = desk.join("lab");
  const std::string well = desk.ask(client, R"({"id": 1, "do": "set", "values": {"/constraints/0/friction/dynamic": 0.3,
                        "/constraints/0/friction/static": 0.4, "/control/kp_N_per_mm": 0.2}})");
  EXPECT_TRUE(Desk::isOk(well)) << well;  // whatever their order
  EXPECT_EQ(desk.host->scene().control.gains.kp_N_per_mm, Vec3(Vec3::Constant(0.2)));
  const std::string none =
      desk.ask(client, R"({"id": 2, "do": "set", "values": {"/control/kp_N_per_mm": 0.9, "/control/law": "none"}})");
  EXPECT_FALSE(Desk::isOk(none));
  EXPECT_EQ(desk.host->scene().control.gains.kp_N_per_mm, Vec3(Vec3::Constant(0.2)));
}

TEST(LiveService, AnswersWithTheTickInWhichItActs) {
  Desk desk;
  const int client = desk.join("lab");
  desk.ask(client, R"({"id": 1, "do": "start"})");
  desk.run(200);
  std::int64_t first = 0;
  const std::uint64_t before = desk.host->snapshot().revision;
  desk.send(client, R"({"id": 2, "do": "set", "values": {"/control/kp_N_per_mm": 0.25}})");
  for (int tick = 0; tick < 5 && first == 0; ++tick) {
    desk.run(1);
    if (desk.host->snapshot().revision != before) first = desk.host->snapshot().ticks;
  }
  for (const std::string& message : desk.take(client)) {
    if (message.starts_with("{\"id\"")) {
      EXPECT_EQ(Desk::number(message, "tick"), static_cast<double>(first));
    }
  }
  EXPECT_GT(first, 0);
}

TEST(LiveService, GivesTheLeaseToOneAndStopToEverybody) {
  Desk desk;
  const int one = desk.join("one"), other = desk.join("other");
  EXPECT_TRUE(Desk::isOk(desk.ask(one, R"({"id": 1, "do": "start"})")));
  const std::string refused = desk.ask(other, R"({"id": 2, "do": "set", "values": {"/control/kp_N_per_mm": 0.2}})");
  EXPECT_NE(refused.find("one steers"), std::string::npos) << refused;
  EXPECT_NE(desk.ask(other, R"({"id": 3, "do": "lease", "lease": "take"})").find("has to give the lease first"),
            std::string::npos);
  const std::string stopped = desk.ask(other, R"({"id": 4, "do": "stop"})");
  EXPECT_NE(stopped.find("\"mode\": \"stopped\""), std::string::npos) << stopped;
  desk.service->disconnect(one);
  EXPECT_TRUE(Desk::isOk(desk.ask(other, R"({"id": 5, "do": "start"})")));
}

TEST(LiveService, LetsAnyoneSteerWhereItIsToldTo) {
  Desk desk(true);
  const int one = desk.join("one"), other = desk.join("other");
  EXPECT_TRUE(Desk::isOk(desk.ask(one, R"({"id": 1, "do": "start"})")));
  EXPECT_TRUE(Desk::isOk(desk.ask(other, R"({"id": 2, "do": "lease", "lease": "take"})")));
  EXPECT_NE(desk.ask(one, R"({"id": 3, "do": "status"})").find("\"steered_by\": \"other\""), std::string::npos);
}

TEST(LiveService, EndsTheForceWithTheLeaseAndKeepsTheScene) {
  Desk desk;
  const int client = desk.join("lab"), watcher = desk.join("watcher");
  desk.ask(client, R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": 0}})");
  desk.ask(client, R"({"id": 2, "do": "start"})");
  desk.run(200);
  desk.ask(client, R"({"id": 3, "do": "force", "f_N": [0.5, 0, 0], "for_ms": 1000})");
  desk.run(5);
  EXPECT_NEAR(desk.host->snapshot().report.f_T_W.x(), 0.5, 0.05);
  desk.service->disconnect(client);
  desk.run(2);
  EXPECT_NEAR(desk.host->snapshot().report.f_T_W.x(), 0.0, 0.05);
  EXPECT_EQ(desk.host->scene().control.gains.kp_N_per_mm, Vec3(Vec3::Zero()));
  bool told = false;
  for (const std::string& message : desk.take(watcher))
    told = told || message.find("\"held\": false") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST(LiveService, TellsEventsToAll) {
  Desk desk;
  const int client = desk.join("lab"), watcher = desk.join("watcher");
  desk.ask(client, R"({"id": 1, "do": "start"})");
  desk.ask(client, R"({"id": 2, "do": "set", "values": {"/control/kp_N_per_mm": 0.2}})");
  desk.ask(client, R"({"id": 3, "do": "mark", "text": "here"})");
  std::string all;
  for (const std::string& message : desk.take(watcher)) all += message;
  for (const char* event : {"\"mode\": \"running\"", "\"event\": \"edit\"", "\"do\": \"set\"", "\"text\": \"here\"",
                            "\"event\": \"lease\""})
    EXPECT_NE(all.find(event), std::string::npos) << event << " in " << all;
}

TEST(LiveService, SendsRowsByStrideAsJsonAndPackedAlike) {
  Desk desk;
  const int text = desk.join("text"), packed = desk.join("packed");
  const std::string columns = R"("columns": ["p_WT_mm", "error_mm"], "hz": 250)";
  const std::string answer = desk.ask(text, R"({"id": 1, "do": "subscribe", )" + columns + "}");
  EXPECT_EQ(Desk::number(answer, "stride"), 4.0);
  desk.ask(packed, R"({"id": 1, "do": "subscribe", "format": "binary", )" + columns + "}");
  desk.take(text);
  desk.take(packed);
  desk.host->run(16);
  desk.service->poll(desk.now_s);
  const std::vector<std::string> rows = desk.take(text), bytes = desk.take(packed);
  ASSERT_EQ(rows.size(), 1U);
  ASSERT_EQ(bytes.size(), 1U);
  const json::Value root = json::parse(rows[0], "").value();
  const json::Value* const ticks = root.find("ticks")->find("tick");
  ASSERT_EQ(ticks->items.size(), 4U);
  ASSERT_EQ(bytes[0].size(), 8 + 4 * 5 * sizeof(double));
  std::uint64_t count = 0;
  std::memcpy(&count, bytes[0].data(), sizeof count);
  EXPECT_EQ(count, 4U);
  for (std::size_t row = 0; row < 4; ++row) {
    double numbers[5];
    std::memcpy(numbers, bytes[0].data() + 8 + row * sizeof numbers, sizeof numbers);
    EXPECT_EQ(numbers[0], ticks->items[row].number);
    EXPECT_EQ(std::fmod(numbers[0], 4.0), 0.0);
    EXPECT_EQ(numbers[2], root.find("ticks")->find("p_WT_mm")->items[row].items[1].number);
    EXPECT_EQ(numbers[4], root.find("ticks")->find("error_mm")->items[row].number);
  }
}

TEST(LiveService, TellsASlowReaderHowManyRowsItLostAndNobodyElse) {
  Desk desk;
  const int slow = desk.join("slow"), fast = desk.join("fast");
  const char* const wanted = R"({"id": 1, "do": "subscribe", "columns": [], "hz": 1000, "format": "binary"})";
  desk.ask(slow, wanted);
  desk.ask(fast, wanted);
  desk.take(slow);
  desk.take(fast);
  std::uint64_t got_fast = 0, got_slow = 0;
  const auto count = [](const std::vector<std::string>& messages, std::uint64_t& rows, double& lost) {
    for (const std::string& message : messages) {
      if (message.starts_with("{")) {
        lost += message.find("\"lag\"") != std::string::npos ? Desk::number(message, "rows") : 0.0;
        continue;
      }
      std::uint64_t more = 0;
      std::memcpy(&more, message.data(), sizeof more);
      rows += more;
    }
  };
  double lost_fast = 0.0, lost_slow = 0.0;
  for (int second = 0; second < 20; ++second) {
    for (int part = 0; part < 10; ++part) {
      desk.host->run(100);
      desk.service->poll(desk.now_s);
    }
    count(desk.take(fast), got_fast, lost_fast);
  }
  count(desk.take(slow), got_slow, lost_slow);
  EXPECT_EQ(got_fast, 20000U);
  EXPECT_EQ(lost_fast, 0.0);
  EXPECT_EQ(got_slow + static_cast<std::uint64_t>(lost_slow), 20000U);
  EXPECT_GT(lost_slow, 0.0);
}

TEST(LiveService, KeepsTheOrderOfRequestsWhileASceneIsRead) {
  Desk desk;
  const int client = desk.join("lab");
  desk.send(client, R"({"id": 1, "do": "load", "file": "14_circle_influence"})");
  desk.send(client, R"({"id": 2, "do": "set", "values": {"/constraints/0/influence/t": 0.25}})");
  const std::string first = desk.ask(client, R"({"id": 3, "do": "status"})");
  EXPECT_TRUE(first.starts_with("{\"id\": 3")) << first;  // it has waited, too, but not for a tick
  desk.run(200);
  EXPECT_EQ(desk.host->scene().constraints[0].influence->t, 0.25);
}

TEST(LiveService, WritesNewFilesInTheSessionsFolderAlone) {
  Desk desk;
  const int client = desk.join("lab");
  EXPECT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 1, "do": "record", "file": "a.h5"})")));
  EXPECT_FALSE(Desk::isOk(desk.ask(client, R"({"id": 2, "do": "record", "file": "b.h5"})")));
  desk.ask(client, R"({"id": 3, "do": "mark", "text": "in the file"})");
  desk.run(300);
  const std::string ended = desk.ask(client, R"({"id": 4, "do": "record", "stop": true})");
  EXPECT_GE(Desk::number(ended, "ticks"), 300.0);
  EXPECT_FALSE(Desk::isOk(desk.ask(client, R"({"id": 5, "do": "record", "file": "a.h5"})")));
  Result<record::Session> session = record::Session::open(desk.folder.path() + "/sessions/a.h5");
  ASSERT_TRUE(session);
  ASSERT_EQ(session.value().markers().size(), 1U);
  EXPECT_EQ(session.value().markers()[0].label, "in the file");
}

}  // namespace
}  // namespace underact::test
