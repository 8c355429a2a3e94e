#include "base/child_process.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

#include "base/check.h"

namespace tetfarm {

void live_with_parent(pid_t parent) {
  TF_CHECK(parent > 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  ::setpgid(0, 0);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

std::vector<char*> exec_arguments(const std::vector<std::string>& words) {
  TF_CHECK(!words.empty());
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  return arguments;
}

}  // namespace tetfarm
