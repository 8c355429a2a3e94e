#include "worker/task_host.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/child_process.h"
#include "base/retry_on_eintr.h"
#include "base/sanitizers.h"
#include "worker/task_environment.h"

namespace tetfarm {
namespace {

// A copy that the C library does not know of is nothing for ThreadSanitizer.
constexpr bool can_copy_itself = !has_thread_sanitizer;

constexpr int most_failures = 3;

/// One datagram, with the store's path behind it and the descriptors beside it.
struct StartRequest {
  pid_t worker = -1;
  std::uint64_t memory_limit_bytes = 0;
};
constexpr std::size_t longest_store = 4096;
constexpr std::size_t descriptor_count = 4;  // in, words, frames, and the one that says go
using Descriptors = std::array<int, descriptor_count>;

union DescriptorSpace {
  cmsghdr header;
  std::array<char, CMSG_SPACE(sizeof(Descriptors))> bytes;
};

bool send_request(int socket, StartRequest request, std::string store, Descriptors fds) {
  std::array<iovec, 2> parts = {iovec{&request, sizeof request}, iovec{store.data(), store.size()}};
  DescriptorSpace space{};
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  message.msg_control = space.bytes.data();
  message.msg_controllen = space.bytes.size();
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof fds);
  std::memcpy(CMSG_DATA(header), fds.data(), sizeof fds);
  return retry_on_eintr([&] { return ::sendmsg(socket, &message, MSG_NOSIGNAL); }) > 0;
}

struct Received {
  StartRequest request;
  std::string store;
  Descriptors fds{};
};

/// Nothing when the worker is gone, or speaks another language.
std::optional<Received> receive_request(int socket) {
  Received received;
  received.store.resize(longest_store);
  std::array<iovec, 2> parts = {iovec{&received.request, sizeof received.request},
                                iovec{received.store.data(), received.store.size()}};
  DescriptorSpace space{};
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  message.msg_control = space.bytes.data();
  message.msg_controllen = space.bytes.size();
  const ssize_t n = retry_on_eintr([&] { return ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC); });
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (n < static_cast<ssize_t>(sizeof received.request) || header == nullptr ||
      header->cmsg_len != CMSG_LEN(sizeof received.fds)) {
    return std::nullopt;
  }
  std::memcpy(received.fds.data(), CMSG_DATA(header), sizeof received.fds);
  received.store.resize(static_cast<std::size_t>(n) - sizeof received.request);
  return received;
}

/// -1: the host is gone, or does not answer, or could not make a process.
pid_t receive_process(int socket, int patience_ms) {
  pollfd waiting{socket, POLLIN, 0};
  if (retry_on_eintr([&] { return ::poll(&waiting, 1, patience_ms); }) <= 0) return -1;
  pid_t process = -1;
  const ssize_t n = retry_on_eintr([&] { return ::recv(socket, &process, sizeof process, 0); });
  return n == static_cast<ssize_t>(sizeof process) ? process : -1;
}

/// fork(), but the copy is a child of this process's parent. The C library need not know: the
/// host has one thread.
pid_t copy_as_sibling() {
  return static_cast<pid_t>(::syscall(SYS_clone, CLONE_PARENT | SIGCHLD, 0, 0, 0, 0));
}

/// The copy of the host: waits until the worker knows it.
void begin_task(const Received& received) {
  char go = 0;
  const int fd = received.fds[3];
  if (retry_on_eintr([&] { return ::read(fd, &go, 1); }) != 1) ::_exit(127);
  become_task_process(received.request.worker, {received.fds[0], received.fds[1], received.fds[2]},
                      received.request.memory_limit_bytes);
}

[[noreturn]] void become_host(char* const* arguments, char* const* environment, pid_t worker,
                              int socket) {
  live_with_parent(worker);
  const int kept = ::fcntl(socket, F_DUPFD, 10);
  ::dup2(kept, task_host_fd);
  ::close_range(task_host_fd + 1, ~0U, 0);
  ::execve(arguments[0], arguments, environment);
  ::_exit(127);
}

}  // namespace

TaskHost::~TaskHost() { end(); }

void TaskHost::end() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  retry_on_eintr([this] { return ::waitpid(process_, nullptr, 0); });
  process_ = -1;
}

bool TaskHost::launch() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
  const std::vector<char*> arguments = exec_arguments(command_);
  const std::vector<std::string> variables = task_environment(::environ);
  const std::vector<char*> environment = exec_arguments(variables);
  const pid_t worker = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become_host(arguments.data(), environment.data(), worker, ends[1]);
  ::close(ends[1]);
  socket_ = ends[0];
  if (process_ < 0) end();
  return process_ > 0;
}

std::optional<pid_t> TaskHost::ask(const std::string& store, TaskFds fds,
                                   std::uint64_t memory_limit_bytes, int patience_ms) {
  if (process_ < 0 && !launch()) return std::nullopt;
  std::array<int, 2> go{};
  if (::pipe2(go.data(), O_CLOEXEC) != 0) return std::nullopt;
  const bool sent = send_request(socket_, {::getpid(), memory_limit_bytes}, store,
                                 {fds.in, fds.words, fds.frames, go[0]});
  ::close(go[0]);
  pid_t task = sent ? receive_process(socket_, patience_ms) : -1;
  if (task > 0 && ::write(go[1], "g", 1) != 1) {  // it was killed before it began
    retry_on_eintr([&] { return ::waitpid(task, nullptr, 0); });
    task = -1;
  }
  ::close(go[1]);
  return task > 0 ? std::optional(task) : std::nullopt;
}

void TaskHost::prepare() {
  if (can_copy_itself && !command_.empty() && process_ < 0) launch();
}

std::optional<pid_t> TaskHost::start(const std::string& store, TaskFds fds,
                                     std::uint64_t memory_limit_bytes, int patience_ms) {
  if (!can_copy_itself || command_.empty() || store.size() > longest_store) return std::nullopt;
  for (int tries = 0; tries < 2 && failures_ < most_failures; ++tries) {
    if (const std::optional<pid_t> task = ask(store, fds, memory_limit_bytes, patience_ms)) {
      failures_ = 0;
      return task;
    }
    end();
    ++failures_;
  }
  return std::nullopt;
}

std::optional<std::string> serve_as_task_host(int socket) {
  ::prctl(PR_SET_NAME, "tetfarm-host");
  while (std::optional<Received> received = receive_request(socket)) {
    const pid_t task = copy_as_sibling();
    if (task == 0) {
      ::close(socket);
      begin_task(*received);
      return received->store;
    }
    for (const int fd : received->fds) ::close(fd);
    if (retry_on_eintr([&] { return ::send(socket, &task, sizeof task, MSG_NOSIGNAL); }) < 0) {
      break;
    }
  }
  return std::nullopt;
}

}  // namespace tetfarm
