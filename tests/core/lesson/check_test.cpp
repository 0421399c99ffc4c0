#include <cmath>

#include "core/base/units.h"
#include "tests/core/lesson/lesson_support.h"

namespace underact::lesson {
namespace {

using test::checkOf;
using test::Moment;
using test::sentenceOf;

/// The state after ticks of a millisecond from begin_s to end_s, each made by put().
template <class Put>
CheckState after(const Check& check, CheckState state, double begin_s, double end_s, const Put& put) {
  for (double t_s = begin_s; t_s < end_s; t_s += 1e-3) {
    Moment moment;
    put(moment, t_s);
    state = afterTick(check, std::move(state), moment.at(t_s).seen());
  }
  return state;
}

template <class Put>
CheckState after(const Check& check, double end_s, const Put& put) {
  return after(check, CheckState{}, 0.0, end_s, put);
}

void push(Moment& moment, double force_N) {
  moment.scene.constraints.clear();
  moment.tick.f_asked_T_W = Vec3(force_N, 0, 0);
}

TEST(Hold, IsSolvedWhereTheBandIsHeldForSoLong) {
  const Check check = checkOf(R"({"measure": "asked_N", "above": 0.3, "below": 0.5, "for_s": 0.2})");
  const auto strong = [](Moment& moment, double) { push(moment, 0.4); };
  EXPECT_FALSE(after(check, 0.19, strong).solved);
  const CheckState done = after(check, 0.25, strong);
  EXPECT_TRUE(done.solved);
  EXPECT_EQ(sentenceOf(check, done), "Held for 0.2 of 0.2 s. The commanded force is 0.40 N.");
  for (const double force_N : {0.2, 0.6, kNotANumber}) {
    EXPECT_FALSE(after(check, 1.0, [force_N](Moment& moment, double) { push(moment, force_N); }).solved) << force_N;
  }
}

TEST(Hold, ABreakBeginsItAnew) {
  const Check check = checkOf(R"({"measure": "asked_N", "above": 0.3, "for_s": 0.2})");
  const auto shaky = [](Moment& moment, double t_s) { push(moment, std::fmod(t_s, 0.15) < 0.02 ? 0.1 : 0.4); };
  const CheckState state = after(check, 2.0, shaky);
  EXPECT_FALSE(state.solved);
  EXPECT_LT(state.held_s, 0.15);
}

TEST(Hold, APauseOfTheClockCountsAsNoTime) {
  const Check check = checkOf(R"({"measure": "asked_N", "above": 0.3, "for_s": 5})");
  CheckState state;
  for (const double t_s : {0.0, 1.0, 10.0, 3.0}) {  // gaps, and another session whose clock is earlier
    Moment moment;
    push(moment, 0.4);
    state = afterTick(check, std::move(state), moment.at(t_s).seen());
  }
  EXPECT_FALSE(state.solved);
  EXPECT_LT(state.held_s, 0.1);
}

TEST(Hold, SaysWhatIsAndWhatShouldBe) {
  const Check check = checkOf(R"({"measure": "asked_N", "above": 0.3, "for_s": 2, "say": "Pull harder."})");
  EXPECT_EQ(sentenceOf(check, {}),
            "Pull harder. Held for 0.0 of 2.0 s. The commanded force is not measured yet; it should be "
            "above 0.30 N.");
  const CheckState state = after(check, 0.01, [](Moment& moment, double) { push(moment, 0.12); });
  EXPECT_EQ(sentenceOf(check, state),
            "Pull harder. Held for 0.0 of 2.0 s. The commanded force is 0.12 N; it should be above 0.30 N.");
  const Check band = checkOf(R"({"measure": "asked_N", "above": 0.3, "below": 0.5})");
  EXPECT_EQ(sentenceOf(band, {}), "The commanded force is not measured yet; it should be between 0.30 N and 0.50 N.");
}

TEST(Near, CountsTheWayOfPlacesAndTheLargestOfAngles) {
  const Check place = checkOf(R"({"measure": "tip_mm", "near": [10, 20, 30], "within": 5.001})");
  const auto isThere = [&place](const Vec3& p_mm) {
    return after(place, 2e-3, [&](Moment& moment, double) { moment.tick.p_WT = 1e-3 * p_mm; }).solved;
  };
  EXPECT_TRUE(isThere({13, 16, 30}));   // 5 mm away
  EXPECT_FALSE(isThere({14, 24, 30}));  // 5.7
  const Check joints = checkOf(R"({"measure": "q_deg", "near": [0, 40, null, null, 180, null], "within": 2})");
  const auto stands = [&joints](double q1, double q2, double q5) {
    return after(joints, 2e-3,
                 [&](Moment& moment, double) {
                   moment.tick.q_rad = {q1 * kRadPerDegree, q2 * kRadPerDegree, 1.0, -1.0, q5 * kRadPerDegree, 0.5};
                 })
        .solved;
  };
  EXPECT_TRUE(stands(1.9, 38.1, 179.0));
  EXPECT_TRUE(stands(0, 40, -179.0));  // the same angle but for a turn
  EXPECT_FALSE(stands(2.1, 40, 180));
  const Check turn = checkOf(R"({"measure": "stylus", "near": [0, 0, 2], "within": 10})");
  EXPECT_EQ(sentenceOf(turn, {}),
            "The direction of the stylus is not measured yet; it should be within 10.00° of (0.00, 0.00, 2.00).");
  const Check count = checkOf(R"({"measure": "solutions_within", "near": 2, "within": 0})");
  EXPECT_EQ(sentenceOf(count, {}), "The number of solutions within the limits is not measured yet; it should be 2.");
}

TEST(Visit, RemembersEachPlaceAndNamesThoseThatAreLeft) {
  const Check check = checkOf(R"({"measure": "tip_mm", "part": 1, "visit": [-40, 0, 40], "within": 3})");
  CheckState state;
  const auto goTo = [&](double x_mm, double t_s) {
    Moment moment;
    moment.tick.p_WT = Vec3(1e-3 * x_mm, 0, 0);
    state = afterTick(check, std::move(state), moment.at(t_s).seen());
  };
  goTo(0, 0.0);
  goTo(38, 0.1);
  EXPECT_EQ(sentenceOf(check, state),
            "2 of 3 reached. Still to reach: -40.0 mm, to within 3.0 mm. The tip x is 38.0 mm.");
  goTo(-36, 9.0);  // visits outlast a pause
  EXPECT_FALSE(state.solved);
  goTo(-37, 9.1);
  EXPECT_TRUE(state.solved);
  EXPECT_EQ(sentenceOf(check, state), "3 of 3 reached.");
}

TEST(Span, BeginsAnewWhereWhatHoldsMeanwhileBreaks) {
  const Check check =
      checkOf(R"({"measure": "tip_mm", "part": 2, "spans": 30, "while": [{"measure": "error_mm", "below": 2}]})");
  const auto slide = [&check](double off_mm) {
    return after(check, 4.0, [off_mm](Moment& moment, double t_s) {
      moment.tick.p_WT = Vec3(0, 0.010 * t_s, 0);
      moment.tick.error_m = t_s > 1.5 && t_s < 1.6 ? 1e-3 * off_mm : 0.0;
    });
  };
  EXPECT_TRUE(slide(1.0).solved);
  const CheckState broken = slide(5.0);
  EXPECT_FALSE(broken.solved);
  EXPECT_EQ(sentenceOf(check, broken), "The tip y moved through 24.0 mm; required: 30.0 mm.");
  const CheckState outside = after(check, 0.5, [](Moment& moment, double) { moment.tick.error_m = 5.1e-3; });
  EXPECT_EQ(sentenceOf(check, outside),
            "The tip y moved through 0.0 mm; required: 30.0 mm. Required at the same time: The error below 2.0 mm; now "
            "5.1 mm.");
}

TEST(Cross, CountsSwingsOfSoMuchWithinSoLong) {
  const Check check = checkOf(R"({"measure": "tip_mm", "part": 3, "crosses": 50, "by": 1, "times": 6, "in_s": 1})");
  const auto swing = [&check](double amplitude_mm, double rate_hz) {
    return after(check, 3.0,
                 [&](Moment& moment, double t_s) {
                   moment.tick.p_WT = Vec3(0, 0, 1e-3 * (50 + amplitude_mm * std::sin(2.0 * kPi * rate_hz * t_s)));
                 })
        .solved;
  };
  EXPECT_TRUE(swing(2.0, 5.0));   // ten a second
  EXPECT_FALSE(swing(0.9, 5.0));  // too small
  EXPECT_FALSE(swing(2.0, 2.0));  // too slow
  EXPECT_FALSE(swing(0.0, 5.0));
}

TEST(AskNumber, TakesWhatIsWithinTheTolerance) {
  const Check check = checkOf(R"({"question": "How long?", "answer": 127.5, "within": 0.5, "unit": "mm"})");
  EXPECT_TRUE(afterAnswer(check, {}, 127.1).solved);
  const CheckState wrong = afterAnswer(check, {}, 128.1);
  EXPECT_FALSE(wrong.solved);
  EXPECT_EQ(sentenceOf(check, {}), "Type your answer.");
  EXPECT_EQ(sentenceOf(check, wrong), "128.1 mm is not correct. Try again.");
  EXPECT_TRUE(afterAnswer(check, wrong, 127.5).solved);  // another go
  EXPECT_FALSE(afterAnswer(check, {}, kNotANumber).solved);
}

TEST(AskNumber, CanBeMeasuredAtThatMoment) {
  const Check check = checkOf(R"({"question": "Where?", "measure": "tip_mm", "part": 1, "within": 1})");
  EXPECT_FALSE(afterAnswer(check, {}, 0.0).solved);  // nothing was measured yet
  const CheckState state = after(check, 2e-3, [](Moment& moment, double) { moment.tick.p_WT = Vec3(0.030, 0, 0); });
  EXPECT_TRUE(afterAnswer(check, state, 30.9).solved);
  EXPECT_FALSE(afterAnswer(check, state, 31.1).solved);
}

TEST(AskChoice, TakesTheRightOneAlone) {
  const Check check = checkOf(R"({"question": "Which?", "choices": ["this", "that"], "right": 2})");
  EXPECT_TRUE(afterAnswer(check, {}, 2).solved);
  EXPECT_EQ(sentenceOf(check, afterAnswer(check, {}, 2)), "“that” is correct.");
  EXPECT_EQ(sentenceOf(check, afterAnswer(check, {}, 1)), "“this” is not correct. Try again.");
  EXPECT_FALSE(afterAnswer(check, {}, 0).solved);
  EXPECT_EQ(sentenceOf(check, {}), "Choose an answer.");
}

TEST(ASolvedCheck, StaysSolvedAndKeepsWhatWasMeasured) {
  const Check check = checkOf(R"({"measure": "asked_N", "above": 0.3})");
  CheckState state = after(check, 2e-3, [](Moment& moment, double) { push(moment, 0.4); });
  ASSERT_TRUE(state.solved);
  state = after(check, std::move(state), 1.0, 1.1, [](Moment& moment, double) { push(moment, 0.0); });
  EXPECT_TRUE(state.solved);
  EXPECT_EQ(sentenceOf(check, state), "The commanded force is 0.40 N.");
  EXPECT_TRUE(isSolved({state}));
  EXPECT_FALSE(isSolved({state, CheckState{}}));
}

TEST(WhatIsTold, CanBeSaidInAnotherLanguage) {
  const Check check = checkOf(R"({"measure": "asked_N", "above": 0.3})");
  const CheckState state = after(check, 2e-3, [](Moment& moment, double) { push(moment, 0.4); });
  const Sentence whole = describeCheck(check, state);  // "%1.", and in it "%1 is %2"
  ASSERT_EQ(whole.places().size(), 1U);
  const Sentence& is = whole.places()[0];
  EXPECT_EQ(is.pattern(), "%1 is %2");
  EXPECT_EQ(is.places().at(0).pattern(), "The commanded force");
  EXPECT_TRUE(is.places().at(1).places().at(0).isNumber());
}

}  // namespace
}  // namespace underact::lesson
