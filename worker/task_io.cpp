#include "worker/task_io.h"

#include <system_error>

#include "base/check.h"
#include "proto/doing.h"
#include "store/attempt_scratch.h"

namespace tetfarm {
namespace {

constexpr std::chrono::milliseconds between_progress{250};

void add_output(wire::Done& done, const std::string& name, const StoredArtifact& stored) {
  wire::Artifact& output = *done.add_outputs();
  output.set_name(name);
  output.set_hash(stored.hash);
  output.set_size(stored.size);
}

}  // namespace

const TaskFile& file_of_leaf(const LeafFiles& files, std::uint64_t heap) {
  const auto found = files.find(heap);
  if (found == files.end()) {
    throw Error(ExitCode::failed, "a file of sub-domain " + std::to_string(heap) + " is missing");
  }
  return found->second;
}

TaskWords given_words(const wire::Assign& assign) {
  TaskWords words;
  for (const wire::Artifact& file : assign.inputs()) {
    words.files.push_back({file.name(), {file.hash(), file.size()}});
  }
  words.texts = {assign.parameters().begin(), assign.parameters().end()};
  return words;
}

TaskIo::TaskIo(const ArtifactStore& store, const wire::Assign& assign, Say say,
               bool is_without_shared_store)
    : store_(store),
      assign_(assign),
      say_(std::move(say)),
      progress_([this](const WorkCount& count) { pass_on(count); }),
      is_without_shared_store_(is_without_shared_store) {
  for (const wire::Artifact& input : assign.inputs()) hash2input_[input.hash()] = &input;
}

void TaskIo::require_no_breach(TaskKind kind, const std::string& breach) {
  if (breach.empty()) return;
  throw OwnDefect(
      "the task to " + std::string(tetfarm::name_of(kind)) + " cannot be done: " + breach, {});
}

std::string TaskIo::read(const TaskFile& file) const {
  return checked_input(file, [&] { return store_.read(file.hash, file.size); });
}

std::string TaskIo::name_of(const TaskFile& file) const {
  const auto found = hash2input_.find(file.hash);
  TF_CHECK(found != hash2input_.end());
  return found->second->name();
}

std::filesystem::path TaskIo::path(const TaskFile& file) const {
  return checked_input(file, [&] {
    store_.verify(file.hash, file.size);
    return store_.path_of(file.hash);
  });
}

TaskFile TaskIo::publish(std::string_view bytes) {
  const StoredArtifact stored = store_.publish(bytes);
  return {stored.hash, stored.size};
}

void TaskIo::add(const TaskWords& made) {
  for (const auto& [name, file] : made.files) add_output(done_, name, {file.hash, file.size});
  for (const auto& [name, value] : made.numbers) number(name, value);
  for (const auto& [name, value] : made.texts) text(name, value);
}

void TaskIo::publish(const std::string& name, std::string_view bytes) {
  add_output(done_, name, store_.publish(bytes));
}

void TaskIo::publish_file(const std::string& name, const std::filesystem::path& path) {
  add_output(done_, name, store_.publish_file(path));
}

void TaskIo::publish_checked_file(const std::string& name, const std::filesystem::path& path,
                                  const StoredArtifact& known) {
  store_.adopt_checked_file(path, known.hash);
  add_output(done_, name, known);
}

std::filesystem::path TaskIo::scratch_path(const std::string& name) const {
  const std::filesystem::path folder = attempt_scratch(store_, AttemptId{assign_.attempt()});
  std::error_code error;
  // Nothing in it has to outlive a loss of power.
  std::filesystem::create_directory(folder, error);
  if (error) throw IoError("cannot create the folder", folder.string(), error.value());
  return folder / name;
}

void TaskIo::number(const std::string& name, double value) {
  (*done_.mutable_numbers())[name] = value;
}

void TaskIo::text(const std::string& name, const std::string& value) {
  (*done_.mutable_texts())[name] = value;
}

void TaskIo::pass_on(const WorkCount& count) {
  const auto now = std::chrono::steady_clock::now();
  const auto stage = static_cast<std::size_t>(count.stage);
  if (said_stages_.test(stage) && now - last_said_ < between_progress) return;
  said_stages_.set(stage);
  last_said_ = now;
  say_(doing_message(count));
}

}  // namespace tetfarm
