// Fits and folders for tests.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "datasets/error.h"
#include "datasets/file.h"
#include "luts/fit/fit.h"

namespace warplut {

// A valid fit with parameters uniform in [-size, size]; size 0 is Catmull-Rom.
inline Fit MakeFit(double size, std::uint64_t seed = 1, const std::string& name = "test_fit") {
  Fit fit;
  fit.name = name;
  fit.optimizer = "lbfgs";
  fit.horizons = {6, 12, 20};
  fit.gain_bound = 1.05;
  fit.keys_a = -0.58;
  fit.seed = seed;
  fit.options = R"({"crops":4})";
  fit.data = {{"frames/0001.png", std::string(40, 'a'), 960, 540}};
  fit.loss = {{0.5, 10, 0.25, 0.3}, {1.0 / 3, 20, 0.1, 0.2}};
  fit.validation = {{"lut", 6, "half", 0.97}, {"keys", 6, "random", 0.98}};
  std::mt19937_64 random(seed);
  fit.parameters.resize(kMlpParameters);
  for (double& p : fit.parameters) {
    p = size * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
  }
  return fit;
}

// The same fit behind a recursive prefilter; that of the spline with k = 1/84 unless told
// otherwise.
inline Fit WithPrefilter(Fit fit, double side = 1.0 / 6 + 1.0 / 84) {
  fit.prefilter.kind = PrefilterKind::kRecursive;
  fit.prefilter.side = static_cast<float>(side);
  return fit;
}

// An empty folder for the running test.
inline std::filesystem::path TestFolder() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  for (char& c : name) c = c == '/' ? '_' : c;
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("warplut_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

// The sentence of the Error that `action` throws, "" if it throws none.
template <class Action>
std::string SentenceOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace warplut
