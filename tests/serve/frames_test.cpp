// Frames that no client would send. UNDERACT_SOAK=1: a million.
#include "tests/serve/desk.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

constexpr const char* kFrames[] = {
    R"({"id": 1, "do": "status"})",
    R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": [0.1, 0.2, 0.3], "/constraints/0/side": "outside"}})",
    R"({"id": 1, "do": "force", "f_N": [0.1, 0.2, 0.3], "for_ms": 20})",
    R"({"id": 1, "do": "constraint.move", "name": "ball", "values": {"center_mm": [1, 2, 3], "radius_mm": 40}, "over_ms": 12})",
    R"({"id": 1, "do": "constraint.add", "constraint": {"type": "point", "position_mm": [0, 0, 0]}})",
    R"({"id": 1, "do": "subscribe", "columns": ["tick", "p_WT_mm"], "hz": 100, "format": "binary"})",
    R"({"id": 1, "do": "lease", "lease": "take"})",
    R"({"id": 1, "do": "mark", "text": "here"})",
    R"({"id": 1, "do": "get", "paths": ["/control/law", "/constraints/0/friction/static"]})",
    R"({"id": 1, "do": "load", "scene": {"underact_scene": 1, "title": "a", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]}})"};
constexpr const char* kTokens[] = {"null",
                                   "1e999",
                                   "-0",
                                   "[",
                                   "]",
                                   "{",
                                   "}",
                                   "\"do\"",
                                   "\"id\"",
                                   ",",
                                   ":",
                                   "/",
                                   "~",
                                   "\\u0000",
                                   "\"",
                                   "1e-320",
                                   "999999999999999999999",
                                   "true",
                                   "hello",
                                   "\xff"};

TEST(LiveServiceFrames, AnyBytesAreAnsweredOrCloseTheConnectionAndTheServoGoesOn) {
  Desk desk;
  Random random{Seed{34}};
  int client = desk.join("fuzz");
  const int frames = sweep(5000, 1'000'000);
  for (int frame = 0; frame < frames; ++frame) {
    const std::string text = mutated(random, kFrames[random.below(std::size(kFrames))], kTokens);
    desk.service->receive(client, {text, random.below(50) != 0, desk.host->stops()}, desk.now_s);
    if (frame % 20 == 0) desk.run(1);
    if (frame % 100 == 0) desk.take(client);
    if (!desk.service->closes(client) && desk.service->mayBeRead(client)) continue;
    desk.take(client);
    desk.service->disconnect(client);
    desk.run(2);
    client = desk.join("fuzz");
  }
  desk.run(2500);
  desk.take(client);
  EXPECT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 1, "do": "stop"})")));
  EXPECT_TRUE(desk.host->snapshot().report.p_WT.allFinite());
}

}  // namespace
}  // namespace underact::test
