#include "worker/task_io.h"

#include <charconv>
#include <system_error>

#include "proto/doing.h"
#include "store/attempt_scratch.h"

namespace tetfarm {
namespace {

constexpr std::chrono::milliseconds between_progress{250};

const wire::Artifact* find_input(const wire::Assign& assign, const std::string& name) {
  for (const wire::Artifact& input : assign.inputs()) {
    if (input.name() == name) return &input;
  }
  return nullptr;
}

void add_output(wire::Done& done, const std::string& name, const StoredArtifact& stored) {
  wire::Artifact& output = *done.add_outputs();
  output.set_name(name);
  output.set_hash(stored.hash);
  output.set_size(stored.size);
}

}  // namespace

TaskIo::TaskIo(const ArtifactStore& store, const wire::Assign& assign, Say say, bool is_apart)
    : store_(store),
      assign_(assign),
      say_(std::move(say)),
      progress_([this](const WorkCount& count) { pass_on(count); }),
      is_apart_(is_apart) {}

bool TaskIo::has_input(const std::string& name) const {
  return find_input(assign_, name) != nullptr;
}

const wire::Artifact& TaskIo::input(const std::string& name) const {
  const wire::Artifact* found = find_input(assign_, name);
  if (found == nullptr) throw Error(ExitCode::failed, "the task has no input \"" + name + "\"");
  return *found;
}

std::string TaskIo::read(const std::string& name) const {
  const wire::Artifact& artifact = input(name);
  return checked_input(artifact, [&] { return store_.read(artifact.hash(), artifact.size()); });
}

std::filesystem::path TaskIo::path(const std::string& name) const {
  const wire::Artifact& artifact = input(name);
  return checked_input(artifact, [&] {
    store_.verify(artifact.hash(), artifact.size());
    return store_.path_of(artifact.hash());
  });
}

bool TaskIo::has_parameter(const std::string& name) const {
  return assign_.parameters().contains(name);
}

std::string TaskIo::parameter(const std::string& name) const {
  const auto found = assign_.parameters().find(name);
  if (found == assign_.parameters().end()) {
    throw Error(ExitCode::failed, "the task has no parameter \"" + name + "\"");
  }
  return found->second;
}

std::uint64_t TaskIo::input_size(const std::string& name) const {
  const wire::Artifact* found = find_input(assign_, name);
  return found == nullptr ? 0 : found->size();
}

double TaskIo::number_parameter(const std::string& name, double otherwise) const {
  return assign_.parameters().contains(name) ? static_cast<double>(whole_parameter(name))
                                             : otherwise;
}

std::int64_t TaskIo::whole_parameter(const std::string& name) const {
  const std::string text = parameter(name);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw Error(ExitCode::failed,
                "the task's parameter " + name + " = \"" + text + "\" is not a whole number");
  }
  return value;
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
