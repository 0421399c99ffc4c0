#include "core/lab/transfer_function.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/property.h"

namespace underact::lab {
namespace {

using Complex = std::complex<double>;

TransferFunction made(std::vector<double> num, std::vector<double> den) {
  return makeTransferFunction(std::move(num), std::move(den)).value();
}

std::string sentenceOf(std::vector<double> num, std::vector<double> den) {
  const Result<TransferFunction> result = makeTransferFunction(std::move(num), std::move(den));
  return result ? Sentence() : result.problems().at(0).sentence;
}

/// The coefficients of the product of s - root, by real factors, so that no root has to be found for it.
std::vector<double> productOf(const std::vector<Complex>& roots) {
  std::vector<Complex> product{1.0};
  for (const Complex& root : roots) {
    product.emplace_back(0.0);
    for (std::size_t index = product.size() - 1; index > 0; --index) product[index] -= root * product[index - 1];
  }
  std::vector<double> real;
  for (const Complex& one : product) real.push_back(one.real());
  return real;
}

TEST(TransferFunction, ZerosInFrontAndCommonPowersOfSGo) {
  EXPECT_EQ(made({0, 0, 2}, {0, 1, 3}).num, std::vector<double>{2});
  EXPECT_EQ(made({0, 0, 2}, {0, 1, 3}).den, (std::vector<double>{1, 3}));
  EXPECT_EQ(made({1, 0}, {1, 1, 0}).num, std::vector<double>{1});  // s / (s^2 + s)
  EXPECT_EQ(made({1, 0}, {1, 1, 0}).den, (std::vector<double>{1, 1}));
  EXPECT_EQ(made({0}, {1, 0}).num, std::vector<double>{0});
}

TEST(TransferFunction, RefusesWhatIsNoTransferFunctionInASentence) {
  EXPECT_NE(sentenceOf({}, {1, 1}).find("numerator"), std::string::npos);
  EXPECT_NE(sentenceOf({1}, {}).find("has no s;"), std::string::npos);
  EXPECT_NE(sentenceOf({1}, {5}).find("has no s;"), std::string::npos);
  EXPECT_NE(sentenceOf({1}, {0, 0}).find("has no s;"), std::string::npos);
  EXPECT_NE(sentenceOf({1, 0, 0}, {1, 1}).find("higher order"), std::string::npos);
  EXPECT_NE(sentenceOf({1}, std::vector<double>(10, 1.0)).find("at most 8"), std::string::npos);
  EXPECT_NE(sentenceOf({kNotANumber}, {1, 1}).find("finite"), std::string::npos);
  EXPECT_NE(sentenceOf({1}, {kInfinity, 1}).find("finite"), std::string::npos);
}

TEST(TransferFunction, GainAtRestIsTheOneOfTheThesis) {
  EXPECT_EQ(gainAtRest(made({5}, productOf({-1, -2, -30}))), 5.0 / 60.0);  // eq. B.10: 1/12
  EXPECT_EQ(gainAtRest(made({1}, {1, 0})), kInfinity);
}

TEST(TransferFunction, PolesAreThoseItWasMadeOf) {
  test::Random random({20070601});
  for (int draw = 0; draw < test::sweep(300, 30000); ++draw) {
    std::vector<Complex> roots;
    const double scale = std::pow(10.0, random.between(-5.0, 5.0));
    while (roots.size() < 1 + random.below(kHighestDegree)) {
      const double re = -scale * random.between(0.05, 3.0), im = scale * random.between(0.3, 3.0);
      if (roots.size() + 2 <= kHighestDegree && random.below(2) == 0) {
        roots.emplace_back(re, im);
        roots.emplace_back(re, -im);
      } else {
        roots.emplace_back(re, 0.0);
      }
    }
    double nearest = kInfinity;  // how well the coefficients determine them
    for (const Complex& a : roots) {
      for (const Complex& b : roots) {
        if (a != b) nearest = std::min(nearest, std::abs(a - b) / scale);
      }
    }
    if (nearest < 0.2) continue;
    std::vector<Complex> found = poles(made({1}, productOf(roots)));
    ASSERT_EQ(found.size(), roots.size());
    for (const Complex& root : roots) {
      const auto best = std::min_element(found.begin(), found.end(), [&](const Complex& a, const Complex& b) {
        return std::abs(a - root) < std::abs(b - root);
      });
      ASSERT_LE(std::abs(*best - root), 1e-8 * scale) << root;
      found.erase(best);
    }
  }
}

TEST(TransferFunction, PolesFarApartAreAllRight) {
  for (const Complex& pole : poles(made({1}, productOf({-1e-4, -1.0, -1e5})))) {
    const double size = -pole.real();
    const double nearest = size < 1e-2 ? 1e-4 : size < 1e2 ? 1.0 : 1e5;
    EXPECT_NEAR(size / nearest, 1.0, 1e-14);
    EXPECT_EQ(pole.imag(), 0.0);
  }
}

TEST(TransferFunction, ItIsToldWhatBecomesOfTheResponse) {
  EXPECT_EQ(behaviourOf(made({1}, {1, 0.8, 1})), Behaviour::Settles);
  EXPECT_EQ(behaviourOf(made({1}, {1, 0, 1})), Behaviour::Swings);
  EXPECT_EQ(behaviourOf(made({1}, {1, 0, 98696.0})), Behaviour::Swings);
  EXPECT_EQ(behaviourOf(made({1}, {1, 0.1, 1, 0.1})), Behaviour::Swings);  // (s + 0.1)(s^2 + 1)
  EXPECT_EQ(behaviourOf(made({1}, {1, 0})), Behaviour::Drifts);
  EXPECT_EQ(behaviourOf(made({1}, {1, 1, 0})), Behaviour::Drifts);
  EXPECT_EQ(behaviourOf(made({1}, {1, 0, 0})), Behaviour::Grows);
  EXPECT_EQ(behaviourOf(made({1}, {1, 0, 2, 0, 1})), Behaviour::Grows);  // (s^2 + 1)^2
  EXPECT_EQ(behaviourOf(made({1}, {1, -1})), Behaviour::Grows);
  EXPECT_EQ(behaviourOf(made({1}, {1, -1e-6, 1})), Behaviour::Grows);
  EXPECT_EQ(behaviourOf(made({1}, {1, 1e-6, 1})), Behaviour::Settles);
}

TEST(TransferFunction, EightEqualPolesSettleThoughTheirRootsScatter) {
  EXPECT_EQ(behaviourOf(made({1}, productOf(std::vector<Complex>(8, -1.0)))), Behaviour::Settles);
  EXPECT_EQ(behaviourOf(made({1}, productOf(std::vector<Complex>(8, -300.0)))), Behaviour::Settles);
}

}  // namespace
}  // namespace underact::lab
