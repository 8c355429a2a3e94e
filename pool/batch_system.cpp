#include "pool/batch_system.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "pool/grid_engine.h"
#include "pool/hosts.h"
#include "pool/htcondor.h"
#include "pool/lsf.h"
#include "pool/slurm.h"

namespace tetfarm {
namespace {

void refuse_control_characters(const std::string& text, const std::string& what) {
  const bool is_bad = std::any_of(text.begin(), text.end(), [](char letter) {
    return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f';
  });
  if (is_bad) throw UsageError("must not contain control characters", what);
}

void check(const PoolSettings& settings) {
  const bool is_plain = settings.name.find_first_not_of(
                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                            "0123456789_-") == std::string::npos;
  if (settings.name.empty() || settings.name.size() > 40 || !is_plain) {
    throw UsageError("a pool's name must be 1 to 40 letters, digits, _ and -", settings.name);
  }
  for (const std::string& path :
       {settings.program, settings.coordinator, settings.store, settings.cache, settings.key,
        settings.coordinator_key, settings.logs}) {
    refuse_control_characters(path, "pool");
  }
  for (const std::string& option : settings.options) refuse_control_characters(option, "--option");
  // Directives have no quoting that all systems share.
  if (settings.logs.find_first_of(" \"'%$") != std::string::npos) {
    throw UsageError("the path of the log folder must not contain spaces, quotes, % or $",
                     settings.logs);
  }
}

}  // namespace

std::unique_ptr<BatchSystem> make_batch_system(const std::string& system,
                                               const PoolSettings& settings) {
  check(settings);
  if (system == "slurm") return std::make_unique<Slurm>(settings);
  if (system == "condor") return std::make_unique<HTCondor>(settings);
  if (system == "lsf") return std::make_unique<Lsf>(settings);
  if (system == "ge") return std::make_unique<GridEngine>(settings);
  if (system == "ssh" && settings.hosts.empty())
    throw UsageError("is missing: name the hosts to start workers on", "--hosts");
  if (system != "ssh" && system != "local") throw UsageError("not a batch system", system);
  return std::make_unique<Hosts>(settings, std::numeric_limits<std::uint16_t>::max());
}

}  // namespace tetfarm
