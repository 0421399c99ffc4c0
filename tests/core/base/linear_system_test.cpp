#include "core/base/linear_system.h"

#include <cmath>

#include "tests/support/property.h"

namespace underact {
namespace {

using System = SymmetricSystem<8>;

/// A a = B B^T + shift, from a random B; a's upper half is rubbish, since none may look at it.
System systemOf(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  System s;
  for (auto& row : s.a) row.fill(kNotANumber);
  s.b.fill(kNotANumber);
  s.size = static_cast<std::size_t>(a.rows());
  for (std::size_t i = 0; i < s.size; ++i) {
    s.b[i] = b[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j <= i; ++j) s.a[i][j] = a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  return s;
}

Eigen::MatrixXd anyMatrix(test::Random& random, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd m(rows, columns);
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = random.between(-1.0, 1.0);
  return m;
}

}  // namespace

TEST(LinearSystem, ACaseByHand) {
  SymmetricSystem<2> s;
  s.a[0][0] = 4.0, s.a[1][0] = 2.0, s.a[1][1] = 3.0;
  s.b = {10.0, 9.0};
  s.size = 2;
  ASSERT_TRUE(solveInPlace(s));
  EXPECT_EQ(s.b[0], 1.5);
  EXPECT_EQ(s.b[1], 2.0);
}

TEST(LinearSystem, SolvesWhatIsPositive) {
  test::Random random(test::Seed{20070661});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const Eigen::Index size = 1 + static_cast<Eigen::Index>(random.below(8));
    const Eigen::MatrixXd root = anyMatrix(random, size, size);
    const Eigen::MatrixXd a = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd x = anyMatrix(random, size, 1);
    System s = systemOf(a, a * x);
    ASSERT_TRUE(solveInPlace(s));
    // Eigenvalues from 0.1 to 8 8: a condition of 1e3.
    for (Eigen::Index k = 0; k < size; ++k) ASSERT_NEAR(s.b[static_cast<std::size_t>(k)], x[k], 1e-12) << size;
  }
}

TEST(LinearSystem, RefusesWhatIsNot) {
  test::Random random(test::Seed{20070662});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const Eigen::Index size = 1 + static_cast<Eigen::Index>(random.below(8));
    const Eigen::MatrixXd root = anyMatrix(random, size, size);
    Eigen::MatrixXd a = root * root.transpose();
    // Along one direction clearly downwards.
    const Eigen::VectorXd down = anyMatrix(random, size, 1).normalized();
    a -= (down.dot(a * down) + 0.1) * down * down.transpose();
    System s = systemOf(a, down);
    ASSERT_FALSE(solveInPlace(s)) << size;
  }
  System s = systemOf(Eigen::MatrixXd::Zero(3, 3), Eigen::VectorXd::Ones(3));
  EXPECT_FALSE(solveInPlace(s));
  s = systemOf(Eigen::MatrixXd::Constant(1, 1, kNotANumber), Eigen::VectorXd::Ones(1));
  EXPECT_FALSE(solveInPlace(s));
}

TEST(LinearSystem, WithoutUnknownsThereIsNothingToDo) {
  System s;
  EXPECT_TRUE(solveInPlace(s));
}

}  // namespace underact
