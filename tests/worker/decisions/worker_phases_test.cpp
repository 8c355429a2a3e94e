#include "worker/decisions/worker_phases.h"

#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace tetfarm {
namespace {

std::set<std::string> drawn() {
  std::ifstream file(TETFARM_SOURCE_DIR "/worker/decisions/worker_states.dot");
  const std::regex arrow(R"(^\s*(\w+) -> (\w+) \[label="(\w+)\"\];$)");
  std::set<std::string> arrows;
  std::string line;
  std::smatch words;
  while (std::getline(file, line)) {
    if (!std::regex_match(line, words, arrow)) continue;
    arrows.insert(words[1].str() + " " + words[3].str() + " " + words[2].str());
  }
  return arrows;
}

template <class Transition>
std::string line_of(const Transition& transition) {
  return std::string(name_of(transition.from)) + " " + name_of(transition.step) + " " +
         name_of(transition.to);
}

TEST(WorkerPhases, are_drawn_as_the_tables_say) {
  std::set<std::string> lines;
  for (const WorkerTransition& transition : worker_transitions()) {
    EXPECT_TRUE(lines.insert(line_of(transition)).second) << line_of(transition);
  }
  for (const LinkTransition& transition : link_transitions()) {
    EXPECT_TRUE(lines.insert(line_of(transition)).second) << line_of(transition);
  }
  EXPECT_THAT(drawn(), testing::ContainerEq(lines));
}

TEST(WorkerPhases, a_step_leads_from_a_phase_to_one_other) {
  std::set<std::string> from;
  for (const WorkerTransition& transition : worker_transitions()) {
    EXPECT_TRUE(
        from.insert(std::string(name_of(transition.from)) + " " + name_of(transition.step)).second);
    EXPECT_EQ(phase_after(transition.from, transition.step), transition.to);
  }
  for (const LinkTransition& transition : link_transitions()) {
    EXPECT_EQ(link_after(transition.from, transition.step), transition.to);
  }
}

TEST(WorkerPhases, nothing_leads_out_of_gone_and_refused_leads_there_from_everywhere_else) {
  for (const WorkerPhase phase :
       {WorkerPhase::idle, WorkerPhase::fetching, WorkerPhase::running, WorkerPhase::overdue,
        WorkerPhase::uploading, WorkerPhase::telling, WorkerPhase::gone}) {
    for (int step = 0; step <= static_cast<int>(WorkerStep::refused); ++step) {
      const bool leads_on = phase_after(phase, static_cast<WorkerStep>(step)).has_value();
      EXPECT_FALSE(phase == WorkerPhase::gone && leads_on);
    }
    if (phase == WorkerPhase::gone) continue;
    EXPECT_EQ(phase_after(phase, WorkerStep::refused), WorkerPhase::gone) << name_of(phase);
  }
  EXPECT_FALSE(link_after(WorkerLink::registered, LinkStep::again));
}

}  // namespace
}  // namespace tetfarm
