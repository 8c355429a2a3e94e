/// What a viewer asks, answered from the rows: jobs, tasks, workers, events, attempts, logs, and
/// why a task waits.
///
/// The same answers come from a running coordinator and from a store at rest (`tetfarm … --store`):
/// both have rows, history and a JobState. Every answer is a page of bounded size; `next` leads on.
#pragma once

#include "coordinator/decisions/job_state.h"
#include "proto/messages.pb.h"
#include "store/job_history.h"

namespace tetfarm {

struct QueryContext {
  const JobState& state;
  const JobHistory& history;
  Moment now;
};

/// @throws Error (not_found) for a job or task that is not there, (usage) for no subject.
/// Cost: jobs look at every task that is at hand, workers at every attempt, tasks of a job and an
/// explanation at the tasks of that job, the others at their page.
wire::QueryReply answer_query(const wire::Query& query, const QueryContext& context);

/// Jobs, on the first page also workers and hosts in quarantine; without what only the
/// authenticator knows. Cost: looks at every task that is at hand.
wire::StatusReply answer_status(const wire::StatusRequest& request, const JobState& state,
                                Moment now);

}  // namespace tetfarm
