/// The state machine of a worker as two tables: what it does with its attempt (WorkerPhase), and
/// how it stands with the coordinator (WorkerLink). worker/decisions/worker_states.dot draws them;
/// a test compares the drawing with the tables. WorkerState (worker_state.h) says when each step is
/// taken.
#pragma once

#include <optional>
#include <span>

namespace tetfarm {

enum class WorkerPhase {
  idle,       ///< holds no attempt
  fetching,   ///< an attempt whose inputs come over the connection
  running,    ///< its process is at work
  overdue,    ///< its process was ended because it took longer than it may
  uploading,  ///< it has a result whose files go over the connection
  telling,    ///< it has a result that is not accepted yet
  gone,       ///< it has left, or was refused
};

enum class WorkerStep {
  assigned,                          ///< a task whose inputs are at hand
  assigned_without_shared_store,     ///< a task whose inputs have to come
  inputs_came,                       ///< all of them
  input_is_damaged,                  ///< at the coordinator, too
  files_failed,                      ///< a full or broken disk, or a damaged output
  start_failed,                      ///< no process could be had
  child_ended,                       ///< with a result, good or bad
  child_ended_without_shared_store,  ///< the same, with files that have to go
  limit_passed,                      ///< of the process's time
  outputs_went,                      ///< all of them
  released,                          ///< the attempt is accepted, stale, not wanted, or handed back
  left,                              ///< a draining worker, with nothing at hand
  refused,                           ///< the coordinator does not want this worker
};

struct WorkerTransition {
  WorkerPhase from;
  WorkerStep step;
  WorkerPhase to;
};
std::span<const WorkerTransition> worker_transitions();
/// Nothing when the step cannot be taken from there.
std::optional<WorkerPhase> phase_after(WorkerPhase from, WorkerStep step);

enum class WorkerLink {
  greeting,     ///< Hello was said; nobody has answered
  unreachable,  ///< Hello could not be said: nobody is at the other end
  registered,   ///< the coordinator said Welcome
};

enum class LinkStep {
  not_sent,   ///< the Hello
  connected,  ///< somebody is at the other end
  again,      ///< it is time to say Hello again
  welcomed,
  forgotten,  ///< the coordinator does not know this connection, or has swept the probe away
  silent,     ///< nothing was heard for a lease: the connection is made anew
};

struct LinkTransition {
  WorkerLink from;
  LinkStep step;
  WorkerLink to;
};
std::span<const LinkTransition> link_transitions();
/// Nothing when the step cannot be taken from there.
std::optional<WorkerLink> link_after(WorkerLink from, LinkStep step);

const char* name_of(WorkerPhase phase);
const char* name_of(WorkerStep step);
const char* name_of(WorkerLink link);
const char* name_of(LinkStep step);

}  // namespace tetfarm
