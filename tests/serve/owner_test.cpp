// What the owner of the scene, the person at a window, may do beside the clients.
#include <gtest/gtest.h>

#include "tests/serve/desk.h"

namespace underact::test {
namespace {

const char* const kSet = R"({"id": 3, "do": "set", "values": {"/control/kp_N_per_mm": 0.2}})";

std::string heardBy(Desk& desk, int client) {
  std::string heard;
  for (const std::string& message : desk.take(client)) heard += message;
  return heard;
}

TEST(SceneOwner, TakesTheLeaseWithTheForceAndGivesItBack) {
  Desk desk;
  const int client = desk.join("client"), other = desk.join("other");
  ASSERT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 1, "do": "start"})")));
  ASSERT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 2, "do": "force", "f_N": [0.3, 0, 0], "for_ms": 1000})")));
  desk.run(60);
  heardBy(desk, other);
  EXPECT_EQ(desk.service->steeringClient(), "client");
  desk.service->takeBack(true);
  EXPECT_EQ(desk.service->steeringClient(), "");
  EXPECT_NE(heardBy(desk, other).find(R"("held": true, "by": "window")"), std::string::npos);
  for (const int one : {client, other})
    EXPECT_NE(desk.ask(one, kSet).find("The person at the window steers"), std::string::npos);
  EXPECT_NE(desk.ask(client, R"({"id": 4, "do": "status"})").find(R"("steered_by": "window")"), std::string::npos);
  EXPECT_NE(desk.ask(client, R"({"id": 5, "do": "lease", "lease": "take"})").find("/lease"), std::string::npos);
  EXPECT_TRUE(Desk::isOk(desk.ask(other, R"({"id": 6, "do": "stop"})")));
  desk.service->takeBack(false);
  EXPECT_NE(heardBy(desk, other).find(R"("held": false)"), std::string::npos);
  EXPECT_TRUE(Desk::isOk(desk.ask(client, kSet)));
}

TEST(SceneOwner, TakesItFromAllWhereAnyoneSteers) {
  Desk desk(true);
  const int client = desk.join("client");
  desk.service->takeBack(true);
  EXPECT_FALSE(Desk::isOk(desk.ask(client, kSet)));
}

TEST(SceneOwner, HisEditsAreToldAsTheWindows) {
  Desk desk;
  const int client = desk.join("client");
  desk.run(1);
  heardBy(desk, client);
  scene::Description edited = desk.host->scene();
  edited.control.gains.kp_N_per_mm.setConstant(0.25);
  ASSERT_TRUE(desk.host->edit(edited).empty());
  desk.run(2);
  const std::string heard = heardBy(desk, client);
  EXPECT_NE(heard.find(R"("do": "edit", "by": "window")"), std::string::npos) << heard;
  EXPECT_TRUE(Desk::isOk(desk.ask(client, R"({"id": 1, "do": "set", "values": {"/control/kp_N_per_mm": 0.3}})")));
  desk.run(2);
  EXPECT_EQ(heardBy(desk, client).find(R"("by": "window")"), std::string::npos)
      << "a client's own edit is the client's";
}

}  // namespace
}  // namespace underact::test
