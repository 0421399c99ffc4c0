#include "core/tradeoff/choice_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/tradeoff/front.h"

namespace underact::tradeoff {
namespace {

scene::Description ball(scene::LawType law = scene::LawType::P) {
  scene::Description scene;
  scene.title = "Ball";
  scene.control.law = law;
  scene.control.gains.kp_N_per_mm.setConstant(0.2);
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), 50.0}, target::Side::Both, {}, {}});
  return scene;
}

std::vector<NamedHand> sweep() {
  return {{"sweep", sim::builtInHand("sweep", 1).value()}};
}

const ChoiceResult* find(const std::vector<ChoiceResult>& choice_results, std::string_view key) {
  const auto found = std::find_if(choice_results.begin(), choice_results.end(),
                                  [&](const ChoiceResult& one) { return one.choice->key == key; });
  return found == choice_results.end() ? nullptr : &*found;
}

bool always(double) {
  return true;
}

}  // namespace

TEST(ChoiceResult, EachChoiceOfTheSceneIsThereAndWhatItHasIsMeasured) {
  const scene::Description scene = ball();
  const std::vector<ChoiceResult> choice_results = measureChoices(scene, sweep(), 0.3, 1000, always);
  const Settings own = settingsOf(scene, 1000);
  for (const Choice& choice : choices()) {
    const ChoiceResult* choice_result = find(choice_results, choice.key);
    ASSERT_EQ(choice_result != nullptr, choice.applies(scene)) << choice.key;
    if (choice_result == nullptr) continue;
    ASSERT_NE(measuredOf(*choice_result, own), nullptr) << choice.key;
    const auto recommended = std::count_if(choice_result->options.begin(), choice_result->options.end(),
                                           [](const Summary& one) { return one.is_recommended; });
    EXPECT_LE(recommended, 1) << choice.key;
    EXPECT_EQ(recommendedOf(*choice_result) != nullptr, recommended == 1);
  }
  EXPECT_EQ(find(choice_results, "velocity"), nullptr) << "a P law has no rate";
  EXPECT_EQ(measuredOf(*find(choice_results, "rate"), own)->option, "1000 Hz");
}

TEST(ChoiceResult, ARateThatIsNoOptionIsMeasuredAsItIsAlsoWhereTheFinestIsNoMultipleOfIt) {
  const scene::Description scene = ball();
  const std::vector<ChoiceResult> choice_results = measureChoices(scene, sweep(), 0.3, 3000, always);
  const ChoiceResult* rate = find(choice_results, "rate");
  ASSERT_NE(rate, nullptr);
  const Summary* own = measuredOf(*rate, settingsOf(scene, 3000));
  ASSERT_NE(own, nullptr);
  EXPECT_EQ(own->option, kAsItIs);
  const auto errorAt = [&](int rate_hz) { return measuredOf(*rate, settingsOf(scene, rate_hz))->error; };
  // The error falls with the rate: off by a tick of 16 kHz it would be that of 0.06 ms at the hand's 0.3 m/s.
  EXPECT_LT(own->error, errorAt(1000));
  EXPECT_GT(own->error, 0.25 * errorAt(8000));
  EXPECT_EQ(valueText(*rate->choice, scene, settingsOf(scene, 3000)), "3000 Hz");
  EXPECT_EQ(measuredOf(*rate, settingsOf(scene, 700)), nullptr);
}

TEST(ChoiceResult, AValueIsToldInWords) {
  scene::Description scene = ball(scene::LawType::PD);
  const auto choice = [](std::string_view key) {
    return *std::find_if(choices().begin(), choices().end(), [&](const Choice& one) { return one.key == key; });
  };
  EXPECT_EQ(valueText(choice("rate"), scene, settingsOf(scene, 4000)), "4000 Hz");
  EXPECT_EQ(valueText(choice("simulation"), scene, settingsOf(scene, 1000)), "trapezoidal, 200 us");
  scene.control.velocity = scene::LowPassFilter{7.0};
  EXPECT_NE(valueText(choice("velocity"), scene, settingsOf(scene, 1000)).find('7'), std::string::npos);
  EXPECT_EQ(valueText(choice("inverse"), scene, settingsOf(scene, 1000)), "closed form");
}

TEST(ChoiceResult, EndsWhenItIsToldToWithWhatWasDone) {
  double last = -1.0;
  int calls = 0;
  const std::vector<ChoiceResult> choice_results = measureChoices(ball(), sweep(), 0.05, 1000, [&](double share) {
    EXPECT_GT(share, last);
    EXPECT_LT(share, 1.0);
    last = share;
    return ++calls < 10;
  });
  EXPECT_EQ(calls, 10);
  ASSERT_EQ(choice_results.size(), 1U);  // six rates, and the beginning of what follows
  EXPECT_STREQ(choice_results[0].choice->key, "rate");
}

/// 0.1 m in 5 ms: at 20 m/s the gate says that it is no hand.
NamedHand leapingHand() {
  sim::HandScript hand;
  hand.hand = {0.01, 1e3, 1e6};
  hand.path = {{0.0, Vec3(-0.05, 0.0, 0.05), Mat3::Identity(), false},
               {0.1, Vec3(-0.05, 0.0, 0.05), Mat3::Identity(), false},
               {0.105, Vec3(0.05, 0.0, 0.05), Mat3::Identity(), false}};
  return {"leap", hand};
}

TEST(ChoiceResult, WhereEveryRunEndsInAFaultThereIsNoWayToRunTheSceneAndTheRestIsStillMeasured) {
  const scene::Description scene = ball();
  const std::vector<NamedHand> leap{leapingHand()}, both{sweep()[0], leapingHand()};
  ASSERT_TRUE(run({scene, leap[0].hand, 0.3}, settingsOf(scene, 1000)).value().faulted);
  double share = 0.0;
  const Progress tell = [&](double now) {
    share = now;
    return true;
  };
  EXPECT_TRUE(measurePoints(scene, leap, 0.3, 1000, tell).empty());
  EXPECT_TRUE(measurePoints(scene, both, 0.3, 1000, tell).empty()) << "one hand in which it faults is enough";
  EXPECT_FALSE(measurePoints(scene, sweep(), 0.3, 1000, tell).empty());
  const std::vector<ChoiceResult> choice_results = measureChoices(scene, leap, 0.3, 1000, tell);
  ASSERT_EQ(choice_results.size(), 4U);  // what the panel's other rows say
  EXPECT_GT(share, 0.9);                 // of the figures that are not there, too
  EXPECT_TRUE(find(choice_results, "rate")->options.empty());
  EXPECT_TRUE(find(choice_results, "simulation")->options.empty());
  EXPECT_EQ(recommendedOf(*find(choice_results, "rate")), nullptr);
  EXPECT_EQ(measuredOf(*find(choice_results, "rate"), settingsOf(scene, 1000)), nullptr);
  EXPECT_EQ(find(choice_results, "inverse")->options.size(), 6U);
  EXPECT_EQ(find(choice_results, "blocks")->options.size(), 6U);
}

TEST(RunDifference, OnALineTwoRatesAgreeWhereverTheirTicksLie) {
  const auto lineAt = [](int rate_hz) {
    tradeoff::Run run;
    run.rate_hz = rate_hz;
    for (int tick = 1; tick <= rate_hz; ++tick) {
      run.p_WT.push_back(Vec3(0.3 * tick / rate_hz, 0.0, 0.0));
      run.f_T_W.push_back(Vec3(0.0, 0.1 * tick / rate_hz, 0.0));
    }
    return run;
  };
  const tradeoff::Run fine = lineAt(16'000);
  for (const int rate_hz : {250, 1000, 3000, 7000, 10'000}) {
    const RunDifference off = differenceOf(lineAt(rate_hz), fine);
    EXPECT_LT(off.max_m, 1e-15) << rate_hz;  // a few roundings of 0.3 m
    EXPECT_LT(off.rms_N, 1e-15) << rate_hz;
  }
  tradeoff::Run shifted = lineAt(3000);
  for (Vec3& p_WT : shifted.p_WT) p_WT.y() += 0.002;
  EXPECT_NEAR(differenceOf(shifted, fine).rms_m, 0.002, 1e-15);
}

}  // namespace underact::tradeoff
