#include <csignal>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/watched_farm.h"
#include "dashboard/dashboard.h"

namespace tetfarm {
namespace {

/// Waits for SIGINT or SIGTERM, which only its own thread takes.
class EndSignal {
 public:
  EndSignal() {
    ::sigemptyset(&signals_);
    ::sigaddset(&signals_, SIGINT);
    ::sigaddset(&signals_, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  void wait() const {
    int signal = 0;
    while (::sigwait(&signals_, &signal) != 0) {
    }
  }

 private:
  sigset_t signals_{};
};

}  // namespace

ExitCode dashboard_command(const DashboardCommand& command) {
  ::signal(SIGPIPE, SIG_IGN);
  const EndSignal end;
  const Dashboard dashboard(
      {.address = command.http_address, .token_file = command.http_token, .acts = command.acts},
      std::make_unique<WatchedFarm>(command.view));
  std::printf("%s\n", dashboard.url().c_str());
  std::fflush(stdout);
  end.wait();
  return ExitCode::ok;
}

}  // namespace tetfarm
