// A caller cancels his own tasks while they are in calls of the library. Each call still returns the right bytes.
#include <gtest/gtest.h>
#include <oblast/oblast.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <atomic>

#include "faults/inputs.h"

namespace oblast::testing {
namespace {

TEST(Caller, whoCancelsHisTasksGetsNoWrongBytes) {
  for (const auto& [name, operands] : threshold_inputs(usual_scale / 4)) {
    SCOPED_TRACE(name);
    const RegionSet expected = overlay(operands.a, operands.b, Operation::unite);
    std::atomic<int> finished = 0, wrong = 0;
    for (const int threads : {0, 2}) {
      for (int question = 1; question < 4; ++question) {
        tbb::task_group_context context;
        tbb::task_group group(context);
        for (int task = 0; task < 3; ++task) {
          group.run([&] {
            std::atomic<int> asked = 0;
            Options options;
            options.threads = threads;
            options.progress = [&](Stage, double) {
              if (++asked == question) context.cancel_group_execution();
              return true;
            };
            wrong += overlay(operands.a, operands.b, Operation::unite, options) != expected;
            ++finished;
          });
        }
        group.wait();
      }
    }
    EXPECT_GT(finished, 0);
    EXPECT_EQ(wrong, 0);
  }
}

TEST(Caller, whoseTaskThrowsGetsNoWrongBytes) {
  const generators::Operands operands = clusters(static_cast<int>(200 * usual_scale));
  const RegionSet expected = overlay(operands.a, operands.b, Operation::unite);
  std::atomic<int> wrong = 0;
  for (int trial = 0; trial < 20; ++trial) {
    EXPECT_THROW(tbb::parallel_for(0, 8,
                                   [&](int i) {
                                     if (i == trial % 8) throw trial;
                                     wrong += overlay(operands.a, operands.b, Operation::unite) != expected;
                                   }),
                 int);
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace oblast::testing
