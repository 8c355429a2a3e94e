#include "coordinator/decisions/tree_progress.h"

#include <tuple>

#include "base/check.h"
#include "coordinator/decisions/task_graph.h"

namespace tetfarm {

void TreeProgress::count(const SubdomainRow& subdomain, std::int64_t change) {
  OfJob& job = jobs_[subdomain.job];
  if (!tetfarm::is_settled(subdomain)) job.unsettled += change;
  if (subdomain.state == SubdomainState::open) job.open += change;
  if (subdomain.state == SubdomainState::leaf) job.leaves += change;
}

const TreeProgress::OfJob& TreeProgress::of(JobId job) const {
  static const OfJob none;
  const auto found = jobs_.find(job);
  return found == jobs_.end() ? none : found->second;
}

const TurnOrder& TreeProgress::set_turns(JobId job, TurnOrder turns) {
  std::optional<TurnOrder>& known = jobs_[job].turns;
  TF_CHECK(!known.has_value());
  return known.emplace(std::move(turns));
}

void TreeProgress::start_turns_anew(JobId job) {
  OfJob& progress = jobs_[job];
  progress.turns.reset();
  progress.turns_over = 0;
}

const TurnOrder* TreeProgress::turns(JobId job) const {
  const std::optional<TurnOrder>& turns = of(job).turns;
  return turns ? &*turns : nullptr;
}

bool TreeProgress::had_all_turns(JobId job) const {
  const OfJob& progress = of(job);
  TF_CHECK(progress.turns.has_value());
  return progress.turns_over == static_cast<std::int64_t>(progress.turns->size());
}

std::uint32_t TreeProgress::former_leaves_above(JobId job, std::uint64_t path) const {
  const std::set<std::uint64_t>& leaves = of(job).former_leaves;
  std::uint32_t count = 0;
  for (std::uint64_t above = path / 2; above > 0; above /= 2) {
    if (leaves.contains(above)) ++count;
  }
  return count;
}

std::vector<std::string> TreeProgress::validate(
    const std::map<SubdomainKey, SubdomainRow>& subdomains) const {
  TreeProgress again;
  for (const auto& [key, subdomain] : subdomains) again.add(subdomain);
  const auto counts = [](const OfJob& job) {
    return std::tuple{job.unsettled, job.open, job.leaves};
  };
  std::vector<std::string> broken;
  for (const auto& [id, job] : jobs_) {
    const std::string name = "job " + std::to_string(id.value) + ": ";
    if (counts(job) != counts(again.of(id))) broken.push_back(name + "sub-domains are miscounted");
    if (job.written > job.leaves + job.chunks)
      broken.push_back(name + "more is written than there are leaves");
    if (job.turns && job.turns_over > static_cast<std::int64_t>(job.turns->size())) {
      broken.push_back(name + "more turns are over than there are");
    }
  }
  for (const auto& [id, job] : again.jobs_) {
    if (jobs_.contains(id)) continue;
    broken.push_back("job " + std::to_string(id.value) + ": its sub-domains are not counted");
  }
  return broken;
}

}  // namespace tetfarm
