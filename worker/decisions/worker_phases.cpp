#include "worker/decisions/worker_phases.h"

#include <array>

namespace tetfarm {
namespace {

using P = WorkerPhase;
using S = WorkerStep;

constexpr std::array phases = {
    WorkerTransition{P::idle, S::assigned, P::running},
    WorkerTransition{P::idle, S::assigned_without_shared_store, P::fetching},
    WorkerTransition{P::idle, S::left, P::gone},
    WorkerTransition{P::idle, S::refused, P::gone},

    WorkerTransition{P::fetching, S::inputs_came, P::running},
    WorkerTransition{P::fetching, S::input_is_damaged, P::telling},
    WorkerTransition{P::fetching, S::files_failed, P::telling},
    WorkerTransition{P::fetching, S::released, P::idle},
    WorkerTransition{P::fetching, S::refused, P::gone},

    WorkerTransition{P::running, S::start_failed, P::telling},
    WorkerTransition{P::running, S::child_ended, P::telling},
    WorkerTransition{P::running, S::child_ended_without_shared_store, P::uploading},
    WorkerTransition{P::running, S::limit_passed, P::overdue},
    WorkerTransition{P::running, S::released, P::idle},
    WorkerTransition{P::running, S::refused, P::gone},

    WorkerTransition{P::overdue, S::child_ended, P::telling},
    WorkerTransition{P::overdue, S::child_ended_without_shared_store, P::uploading},
    WorkerTransition{P::overdue, S::released, P::idle},
    WorkerTransition{P::overdue, S::refused, P::gone},

    WorkerTransition{P::uploading, S::outputs_went, P::telling},
    WorkerTransition{P::uploading, S::files_failed, P::telling},
    WorkerTransition{P::uploading, S::released, P::idle},
    WorkerTransition{P::uploading, S::refused, P::gone},

    WorkerTransition{P::telling, S::released, P::idle},
    WorkerTransition{P::telling, S::refused, P::gone},
};

using L = WorkerLink;
using T = LinkStep;

constexpr std::array links = {
    LinkTransition{L::greeting, T::not_sent, L::unreachable},
    LinkTransition{L::greeting, T::again, L::greeting},
    LinkTransition{L::greeting, T::forgotten, L::greeting},
    LinkTransition{L::greeting, T::welcomed, L::registered},

    LinkTransition{L::unreachable, T::connected, L::greeting},
    LinkTransition{L::unreachable, T::again, L::greeting},
    LinkTransition{L::unreachable, T::forgotten, L::greeting},
    LinkTransition{L::unreachable, T::welcomed, L::registered},

    LinkTransition{L::registered, T::welcomed, L::registered},
    LinkTransition{L::registered, T::forgotten, L::greeting},
    LinkTransition{L::registered, T::silent, L::greeting},
};

template <class State, class Step, class Table>
std::optional<State> after(State from, Step step, const Table& table) {
  for (const auto& transition : table) {
    if (transition.from == from && transition.step == step) return transition.to;
  }
  return std::nullopt;
}

}  // namespace

std::span<const WorkerTransition> worker_transitions() { return phases; }
std::span<const LinkTransition> link_transitions() { return links; }

std::optional<WorkerPhase> phase_after(WorkerPhase from, WorkerStep step) {
  return after(from, step, phases);
}

std::optional<WorkerLink> link_after(WorkerLink from, LinkStep step) {
  return after(from, step, links);
}

const char* name_of(WorkerPhase phase) {
  constexpr std::array names = {"idle",      "fetching", "running", "overdue",
                                "uploading", "telling",  "gone"};
  return names.at(static_cast<std::size_t>(phase));
}

const char* name_of(WorkerStep step) {
  constexpr std::array names = {"assigned",     "assigned_without_shared_store",
                                "inputs_came",  "input_is_damaged",
                                "files_failed", "start_failed",
                                "child_ended",  "child_ended_without_shared_store",
                                "limit_passed", "outputs_went",
                                "released",     "left",
                                "refused"};
  return names.at(static_cast<std::size_t>(step));
}

const char* name_of(WorkerLink link) {
  constexpr std::array names = {"greeting", "unreachable", "registered"};
  return names.at(static_cast<std::size_t>(link));
}

const char* name_of(LinkStep step) {
  constexpr std::array names = {"not_sent", "connected", "again",
                                "welcomed", "forgotten", "silent"};
  return names.at(static_cast<std::size_t>(step));
}

}  // namespace tetfarm
