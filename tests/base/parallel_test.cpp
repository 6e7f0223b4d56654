// The loop over all cores: each step once, the first exception carried to the caller, the end when asked.
#include "host/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

constexpr std::size_t many = 10'000;

TEST(Parallel, TakesEachStepOnce) {
  std::vector<std::atomic<int>> taken(many);
  parallel_for(many, [&](std::size_t k) { ++taken[k]; });
  for (std::size_t k = 0; k < many; ++k) EXPECT_EQ(taken[k], 1) << k;
}

TEST(Parallel, ZeroStepsCallNothing) {
  parallel_for(0, [](std::size_t) { FAIL(); });
}

// Each thread takes a step before any may end one.
TEST(Parallel, AllCoresWorkAtOnce) {
  std::atomic<std::size_t> begun = 0;
  parallel_for(hardware_threads(), [&](std::size_t) {
    ++begun;
    while (begun < hardware_threads()) std::this_thread::yield();
  });
  EXPECT_EQ(begun, hardware_threads());
}

TEST(Parallel, CarriesAnExceptionToTheCaller) {
  std::atomic<std::size_t> begun = 0;
  std::atomic<std::size_t> running = 0;
  try {
    parallel_for(many, [&](std::size_t k) {
      ++begun;
      ++running;
      if (k == many / 2) {
        --running;
        throw std::out_of_range("step " + std::to_string(k));
      }
      --running;
    });
    FAIL() << "the exception was lost";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "step 5000");
  }
  EXPECT_EQ(running, 0u) << "a step was still running";
  EXPECT_GT(begun, many / 2);
}

TEST(Parallel, BeginsNoStepAfterAnException) {
  std::atomic<std::size_t> begun = 0;
  EXPECT_THROW(parallel_for(many,
                            [&](std::size_t k) {
                              ++begun;
                              if (k == 0) throw std::runtime_error("the first step fails");
                              std::this_thread::sleep_for(std::chrono::microseconds(100));
                            }),
               std::runtime_error);
  EXPECT_LT(begun, many) << "the other threads went on to the end";
}

TEST(Parallel, EndsWhenAsked) {
  std::stop_source stop;
  std::atomic<std::size_t> begun = 0;
  try {
    parallel_for(
        many,
        [&](std::size_t) {
          if (++begun == 100) stop.request_stop();
        },
        stop.get_token());
    FAIL() << "the loop went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault(), Fault::stopped);
  }
  EXPECT_GE(begun, 100u);
  EXPECT_LE(begun, 100 + hardware_threads());
}

}  // namespace
}  // namespace brdftab
