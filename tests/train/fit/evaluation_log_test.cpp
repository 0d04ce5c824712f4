#include "train/fit/evaluation_log.h"

#include <gtest/gtest.h>

#include "tests/datasets/expect_error.h"
#include "train/fit/minimize.h"

namespace warplut {
namespace {

// (x - 3)^2 + (y + 1)^4
class Bowl final : public ParameterFunction {
 public:
  double Evaluate(const double* p, double* gradient) override {
    ++evaluations;
    const double x = p[0] - 3, y = p[1] + 1;
    if (gradient != nullptr) {
      gradient[0] = 2 * x;
      gradient[1] = 4 * y * y * y;
    }
    return x * x + y * y * y * y;
  }
  int evaluations = 0;
};

using Minimizer = void (*)(ParameterFunction&, int, const MinimizeCallback&, std::vector<double>&);

void Adam(ParameterFunction& function, int iterations, const MinimizeCallback& callback,
          std::vector<double>& parameters) {
  AdamState state;
  MinimizeAdam(function, iterations, callback, state, parameters);
}

TEST(LoggedFunction, ADescentThatIsTakenUpComesToTheSameBits) {
  for (const Minimizer minimize : {Minimizer(MinimizeLbfgs), Minimizer(Adam)}) {
    Bowl whole_bowl;
    std::vector<double> whole = {0.3, 0.7};
    minimize(
        whole_bowl, 9, [](const double*, double) { return true; }, whole);
    ASSERT_GT(whole_bowl.evaluations, 8);

    std::vector<Evaluation> log;
    Bowl first;
    int appended = 0, calls = 0;
    {
      LoggedFunction logged(first, 2, &log, [&] { ++appended; });
      std::vector<double> parameters = {0.3, 0.7};
      minimize(
          logged, 9, [&](const double*, double) { return ++calls < 4; }, parameters);
      EXPECT_EQ(logged.evaluations(), log.size());
    }
    EXPECT_EQ(appended, first.evaluations);
    EXPECT_LT(first.evaluations, whole_bowl.evaluations);

    Bowl second;
    LoggedFunction logged(second, 2, &log, [&] { ++appended; });
    std::vector<double> parameters = {0.3, 0.7};
    minimize(
        logged, 9, [](const double*, double) { return true; }, parameters);
    EXPECT_EQ(parameters, whole);
    EXPECT_EQ(first.evaluations + second.evaluations, whole_bowl.evaluations);
    EXPECT_EQ(log.size(), static_cast<std::size_t>(whole_bowl.evaluations));
  }
}

TEST(LoggedFunction, RefusesALogWithoutAGradientThatIsAskedFor) {
  Bowl bowl;
  std::vector<Evaluation> log = {{1.5, {}}};
  LoggedFunction logged(bowl, 2, &log, {});
  const double at[] = {0, 0};
  double gradient[2];
  ExpectError([&] { logged.Evaluate(at, gradient); }, {"checkpoint"});
  LoggedFunction again(bowl, 2, &log, {});
  EXPECT_EQ(again.Evaluate(at, nullptr), 1.5);
  EXPECT_EQ(bowl.evaluations, 0);
}

}  // namespace
}  // namespace warplut
