#include "store/rows.h"

namespace tetfarm {

bool is_end(JobPhase phase) { return phase != JobPhase::running && phase != JobPhase::waiting; }

const char* name_of(JobPhase phase) {
  switch (phase) {
    case JobPhase::running:
      return "running";
    case JobPhase::done:
      return "done";
    case JobPhase::failed:
      return "failed";
    case JobPhase::cancelled:
      return "cancelled";
    case JobPhase::waiting:
      return "waiting";
  }
  return "?";
}

const char* name_of(TaskState state) {
  switch (state) {
    case TaskState::waiting:
      return "waiting";
    case TaskState::ready:
      return "ready";
    case TaskState::leased:
      return "leased";
    case TaskState::done:
      return "done";
    case TaskState::failed:
      return "failed";
    case TaskState::replaced:
      return "replaced";
  }
  return "?";
}

const char* name_of(AttemptState state) {
  switch (state) {
    case AttemptState::running:
      return "running";
    case AttemptState::done:
      return "done";
    case AttemptState::failed:
      return "failed";
    case AttemptState::crashed:
      return "crashed";
    case AttemptState::killed:
      return "killed";
    case AttemptState::lost:
      return "lost";
    case AttemptState::returned:
      return "returned";
    case AttemptState::revoked:
      return "revoked";
    case AttemptState::starved:
      return "starved";
  }
  return "?";
}

const char* name_of(SubdomainState state) {
  switch (state) {
    case SubdomainState::open:
      return "open";
    case SubdomainState::cut:
      return "cut";
    case SubdomainState::leaf:
      return "leaf";
    case SubdomainState::joined:
      return "joined";
  }
  return "?";
}

}  // namespace tetfarm
