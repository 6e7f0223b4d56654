// The device that tests of fits run on.
#pragma once

#include <gtest/gtest.h>

#include "host/compute/opencl/engine.hpp"
#include "host/fit/minimizer.hpp"

namespace brdftab {

/// Skips where the device has no fp64, which a fit takes.
class OnFitDevice : public testing::Test {
 protected:
  static void SetUpTestSuite() { silence_solver(); }
  void SetUp() override {
    if (!select_device(std::nullopt).has_fp64) GTEST_SKIP() << "the device has no fp64";
  }
  static const Engine& engine() {
    static const Engine engine(select_device(std::nullopt), Precision::float64, Precision::float32);
    return engine;
  }
};

}  // namespace brdftab
