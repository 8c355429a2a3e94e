#include "cli/probe.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "base/clock.h"
#include "base/error_with_help.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

TEST(Probes, bring_what_was_found_from_another_process) {
  const Findings findings = {{"disk", Verdict::ok, std::string(100'000, 'x'), ""},
                             {"disk", Verdict::problem, "full", "make room"}};
  EXPECT_EQ(looked_at_within({"disk", [&] { return findings; }, ""}, 5'000), findings);
  const Findings where =
      looked_at_within({"disk",
                        [] {
                          return Findings{{"", Verdict::ok, std::to_string(::getpid()), ""}};
                        },
                        ""},
                       5'000);
  ASSERT_EQ(where.size(), 1U);
  EXPECT_NE(where[0].found, std::to_string(::getpid()));
}

TEST(Probes, make_a_problem_of_what_is_thrown) {
  const Findings findings = looked_at_within(
      {"keys", []() -> Findings { throw UsageError("others may read it", "a.key"); }, "chmod 600"},
      5'000);
  EXPECT_EQ(findings,
            (Findings{{"keys", Verdict::problem, "a.key: others may read it", "chmod 600"}}));
  const Findings helped = looked_at(
      {"keys", []() -> Findings { throw ErrorWithHelp(ExitCode::failed, "gone", "mount it"); },
       "another remedy"});
  EXPECT_EQ(helped.front().remedy, "mount it") << "the error knows better";
}

TEST(Probes, that_are_kept_waiting_are_given_up_in_time) {
  const std::int64_t begun_ms = steady_ms();
  const Findings findings =
      looked_at_within({"files",
                        []() -> Findings {
                          std::this_thread::sleep_for(std::chrono::minutes(5));
                          return {};
                        },
                        "mount it"},
                       300);
  EXPECT_LT(steady_ms() - begun_ms, 5'000);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::problem);
  EXPECT_EQ(findings[0].found, "no answer within 1 s: looking at it was given up");
  EXPECT_EQ(findings[0].remedy, "mount it");
}

TEST(Probes, that_crash_are_a_problem) {
  const Findings findings = looked_at_within({"files",
                                              []() -> Findings {
                                                ::raise(SIGKILL);
                                                return {};
                                              },
                                              ""},
                                             5'000);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].found, HasSubstr("crash"));
}

}  // namespace
}  // namespace tetfarm
