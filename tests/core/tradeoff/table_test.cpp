#include "core/tradeoff/table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "core/record/recorder.h"
#include "core/scene/read.h"
#include "core/servo/host.h"
#include "core/tradeoff/front.h"
#include "core/tradeoff/model.h"
#include "tests/support/random.h"

namespace underact::tradeoff {
namespace {

/// A line of CSV; a field in quotes may hold commas.
std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

/// The rows of a table that ships, by column.
std::vector<std::map<std::string, std::string>> shippedTable(const std::string& name) {
  std::ifstream file(std::string(UNDERACT_SOURCE) + "/resources/lab/" + name);
  EXPECT_TRUE(file) << name;
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = fieldsOf(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = fieldsOf(line);
    std::map<std::string, std::string>& row = rows.emplace_back();
    for (std::size_t column = 0; column < columns.size(); ++column) row[columns[column]] = fields.at(column);
  }
  return rows;
}

Summary option(const char* name, double cost, double error) {
  Summary summary{"rate", name, 1};
  summary.cost_us_per_s = cost;
  summary.error = error;
  return summary;
}

std::string recommendedOf(double bound, std::vector<Summary> options) {
  recommend(bound, options);
  std::string names;
  for (const Summary& one : options) names += one.is_recommended ? one.option : "";
  return names;
}

TEST(Recommend, TheCheapestWithinTheBoundAndOfThoseThatCostTheSameTheMostExact) {
  EXPECT_EQ(recommendedOf(1.0, {option("a", 100, 2.0), option("b", 200, 0.9), option("c", 400, 0.1)}), "b");
  EXPECT_EQ(recommendedOf(1.0, {option("a", 100, 0.9), option("b", 109, 0.5), option("c", 111, 0.1)}), "b");
  EXPECT_EQ(recommendedOf(1.0, {option("a", 100, 0.5), option("b", 99, 0.5)}), "a");  // of equals the first
  EXPECT_EQ(recommendedOf(0.05, {option("a", 100, 2.0), option("b", 200, 0.9)}), "");
  Summary never = option("n", 1, 0.0);
  never.runs = 0;
  EXPECT_EQ(recommendedOf(1.0, {never, option("a", 100, 0.5)}), "a");
}

TEST(ShippedTable, ItsRecommendationsAreTheProgramsDefaults) {
  std::map<std::string, std::vector<Summary>> by_choice;
  for (const auto& row : shippedTable("trade_choices.csv")) {
    Summary one{row.at("choice"), row.at("option"), std::stoi(row.at("runs"))};
    one.cost_us_per_s = std::stod(row.at("us_per_s"));
    one.error = std::stod(row.at("error"));
    one.is_default = row.at("default") == "true";
    one.is_recommended = row.at("recommended") == "true";
    by_choice[one.choice].push_back(one);
  }
  EXPECT_EQ(by_choice.size(), choices().size());
  for (const Choice& choice : choices()) {
    std::vector<Summary>& options = by_choice[choice.key];
    ASSERT_EQ(options.size(), choice.options.size()) << choice.key;
    const std::string& default_value = choice.options[optionOf(choice, Settings{}).value()].name;
    EXPECT_EQ(recommendedOf(choice.bound, options), default_value)
        << choice.key;  // the rule, applied to the table's numbers
    for (const Summary& one : options) {
      EXPECT_EQ(one.is_recommended, one.option == default_value) << choice.key << ", " << one.option;
      EXPECT_EQ(one.is_default, one.option == default_value) << choice.key << ", " << one.option;
    }
  }
}

TEST(ShippedTable, TheDefaultsAreThoseOfSceneFilesServoAndRecorder) {
  const scene::Control control;
  const Settings default_value;
  EXPECT_EQ(default_value.velocity, control.velocity);
  EXPECT_EQ(default_value.search, scene::Mesh{}.search);
  EXPECT_EQ(default_value.search, scene::Curve{}.search);
  EXPECT_EQ(default_value.solver, scene::VirtualManipulator{}.solver);
  EXPECT_EQ(default_value.simulation, scene::Description{}.simulation);
  EXPECT_EQ(integrationOf(default_value.simulation).substep_ns, Integration{}.substep_ns);
  EXPECT_EQ(integrationOf(default_value.simulation).integrator, Integration{}.integrator);
  EXPECT_EQ(default_value.rate_hz, servo::HostOptions{}.rate_hz);
  EXPECT_EQ(default_value.block_s, record::RecorderOptions{}.block_s);
}

TEST(ShippedTable, EveryShippedScenesFrontHasThreePointsAtLeast) {
  std::map<std::string, std::set<std::string>> fronts;
  for (const auto& row : shippedTable("trade_fronts.csv")) {
    std::set<std::string>& points = fronts[row.at("scene")];
    if (row.at("on_front") == "true") points.insert(row.at("us_per_s") + " " + row.at("error_mm"));
  }
  EXPECT_FALSE(fronts.empty());  // of which scenes: tests/guide/test_lab_tables.py
  for (const auto& [scene, points] : fronts) EXPECT_GE(points.size(), 3U) << scene;
}

TEST(Front, IsWhatNothingElseBeatsInBoth) {
  underact::test::Random random(underact::test::Seed{20261122});
  for (int round = 0; round < 200; ++round) {
    std::vector<Point> points(1 + random.below(40));
    for (Point& point : points) {
      point.cost_us_per_s = static_cast<double>(random.below(20));
      point.error_mm = static_cast<double>(random.below(20));
    }
    markFront(points);
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const Point& one) { return one.on_front; }));
    for (const Point& one : points) {
      bool beaten = false;
      for (const Point& other : points) {
        beaten = beaten || (other.cost_us_per_s < one.cost_us_per_s && other.error_mm <= one.error_mm) ||
                 (other.cost_us_per_s <= one.cost_us_per_s && other.error_mm < one.error_mm);
      }
      EXPECT_EQ(one.on_front, !beaten);
    }
  }
}

NamedHand handNamed(const char* name) {
  return {name, sim::builtInHand(name, 1).value()};
}

TEST(Front, OfASceneGoesFromTheFastToTheExact) {
  const scene::Description circle =
      scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/05_circle.json").value();
  double last = -1.0;
  const std::vector<Point> points =
      measurePoints(circle, {handNamed("sweep"), handNamed("stab")}, 0.7, 1000, [&](double share) {
        EXPECT_GE(share, last);
        last = share;
        return true;
      });
  std::vector<Point> front;
  std::copy_if(points.begin(), points.end(), std::back_inserter(front), [](const Point& one) { return one.on_front; });
  ASSERT_GE(front.size(), 3U);  // each rate costs twice the one before
  for (std::size_t index = 1; index < front.size(); ++index) {
    EXPECT_GE(front[index].cost_us_per_s, front[index - 1].cost_us_per_s);
    EXPECT_LE(front[index].error_mm, front[index - 1].error_mm);
  }
  EXPECT_LT(front.front().settings.rate_hz, front.back().settings.rate_hz);
  EXPECT_EQ(std::count_if(points.begin(), points.end(), [](const Point& one) { return one.is_own; }), 1);
}

TEST(Front, EndsWhereItIsToldTo) {
  const scene::Description circle =
      scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/05_circle.json").value();
  int told = 0;
  const std::vector<Point> points =
      measurePoints(circle, {handNamed("still")}, 0.2, 1000, [&](double) { return ++told < 5; });
  EXPECT_LE(points.size(), 4U);
}

TEST(Rows, AreOfEveryOptionThatTheSceneHas) {
  Plan plan;
  plan.scenes = {{"line", scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/12_line_pid.json").value()}};
  plan.hands = {handNamed("tremor")};
  plan.choices = {"velocity", "inverse", "search"};
  plan.seconds = 0.5;
  const std::vector<TradeoffRow> rows = measureRows(plan, [](double) { return true; });
  std::map<std::string, int> counts, defaults;
  for (const TradeoffRow& row : rows) {
    ++counts[row.choice];
    defaults[row.choice] += row.is_default ? 1 : 0;
  }
  EXPECT_EQ(counts, (std::map<std::string, int>{{"velocity", 10}, {"inverse", 6}}));  // there is nothing to seek
  EXPECT_EQ(defaults, (std::map<std::string, int>{{"velocity", 1}, {"inverse", 1}}));
}

TEST(Model, SaysWhatASceneRequiresAndWhatItCannotUse) {
  const auto modelOfScene = [](const char* name) {
    return modelOf({scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + name + ".json").value(),
                    sim::builtInHand("sweep", 1).value(), 0.2})
        .value();
  };
  std::map<std::string, Quantity> point, line, circle;
  for (const Quantity& one : modelOfScene("01_point").quantities) point[one.key] = one;
  for (const Quantity& one : modelOfScene("12_line_pid").quantities) line[one.key] = one;
  for (const Quantity& one : modelOfScene("14_circle_influence").quantities) circle[one.key] = one;
  EXPECT_FALSE(point["error_rate"].required);
  EXPECT_FALSE(point["orientation"].required);
  EXPECT_TRUE(point["motor_torques"].required);
  EXPECT_FALSE(point["friction"].adds_ns.has_value());  // nothing to slide along
  EXPECT_FALSE(point["influence"].adds_ns.has_value());
  EXPECT_TRUE(line["error_integral"].required);
  EXPECT_TRUE(line["friction"].adds_ns.has_value());
  EXPECT_TRUE(circle["influence"].required);
  EXPECT_TRUE(circle["orientation"].required);
}

}  // namespace
}  // namespace underact::tradeoff
