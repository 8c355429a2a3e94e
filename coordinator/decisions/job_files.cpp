/// JobState, the part about files between tasks that nobody needs any more. It reads the rows that
/// the others change, and decides nothing about tasks.
#include "coordinator/decisions/job_state.h"

namespace tetfarm {

FileStage JobState::file_stage(JobId job) const {
  if (durable_.jobs.at(job).phase == JobPhase::done) return FileStage::over;
  if (find_task(job, TaskKind::assemble, 0) != nullptr) return FileStage::assembling;
  if (find_done(job, TaskKind::number, 0) != nullptr) return FileStage::numbered;
  return FileStage::growing;
}

/// The job's stage, after all of its files were looked at where it is another than before.
JobState::FilesOfJob JobState::files_of(JobId job) {
  const auto [place, is_new] = files_of_jobs_.try_emplace(job);
  FilesOfJob& known = place->second;
  if (is_new) known.stay = keeps_all(rules_.keeps_all_files, durable_.jobs.at(job));
  const FileStage stage = file_stage(job);
  if (!is_new && known.stage == stage) return known;
  known.stage = stage;
  const FilesOfJob files = known;
  for (const TaskId id : lists_.tasks_of(job)) note_files(durable_.tasks.at(id), files);
  note_files_of_tree(job);
  return files;
}

void JobState::note_files_of_tree(JobId job) {
  const FilesOfJob files = files_of(job);
  for (auto node = durable_.subdomains.lower_bound({job, 0});
       node != durable_.subdomains.end() && node->first.first == job; ++node) {
    note_files(node->second, files);
  }
}

void JobState::note_files(const TaskRow& task, const FilesOfJob& files) {
  const bool outputs = files.stay ? has_result(task) : may_get_readers(task, files.stage);
  const bool inputs = files.stay || needs_inputs(task, files.stage);
  const bool wants_more = file_needs_.update(task, inputs, outputs);
  // One that was done before: what it read may be about to be removed, and stays if asked for.
  if (!wants_more || task.outputs.empty()) return;
  for (const ArtifactRef& input : task.inputs) has_file_(input);
}

void JobState::note_files(const SubdomainRow& subdomain, const FilesOfJob& files) {
  file_needs_.update(subdomain, !files.stay && may_get_readers(subdomain, files.stage));
}

std::vector<std::string> JobState::take_unneeded_files() {
  std::vector<std::string> unneeded = file_needs_.take_unneeded();
  std::erase_if(unneeded,
                [this](const std::string& hash) { return finished_->needs(hash, at_hand_); });
  return unneeded;
}

}  // namespace tetfarm
