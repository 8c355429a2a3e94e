#include <stdlib.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "coordinator/request_handler.h"
#include "store/job_database.h"
#include "tests/fuzz/fuzz_targets.h"

namespace tetfarm::fuzz {
namespace {

namespace fs = std::filesystem;

/// In memory where there is such a place: submitting writes files durably.
ArtifactStore make_store() {
  std::string folder = fs::is_directory("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
  folder += "/tetfarm-fuzz-XXXXXX";
  TF_CHECK(::mkdtemp(folder.data()) != nullptr);
  static std::string to_remove;
  to_remove = folder;
  std::atexit([] { fs::remove_all(to_remove); });
  std::ofstream(folder + "/store_id") << "fuzz";
  return ArtifactStore(folder);
}

void take_turn(RequestHandler& handler, JobState& state, const JobDatabase& database,
               const ArtifactStore& store, const Authenticator& authenticator, Moment now) {
  state.tick(now);
  handler.carry_out(state, now);
  state.take_changes();
  handler.answer_questions(state, database.history(), authenticator, now);
  handler.take_replies();
  handler.take_complaints();
  for (const FileOrder& order : handler.take_file_orders(state, now)) {
    handler.note_file(carry_out(order, store), state, now);
  }
  TF_CHECK(state.validate().empty());
}

}  // namespace

void wire(std::string_view input) {
  static const ArtifactStore store = make_store();
  static const SurfaceRoots roots({}, {store.folder(), {}, {}, {}});
  static const JobDatabase database(store.folder() / "tetfarm.db");
  static zmq::context_t context;
  static Refusals refusals;
  static const Authenticator authenticator(context, {}, refusals);
  Moment now{1000, 1000};
  RequestHandler handler(store, roots, {.max_workers = 4}, refusals);
  JobState state(
      {}, {}, [](const ArtifactRef& file) { return store.has(file.hash, file.size); }, now);
  while (input.size() >= 2) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(input[i]); };
    const std::size_t size = byte(0) + 256U * (byte(1) & 63U);
    const unsigned who = byte(1) >> 6U;
    input.remove_prefix(2);
    // Three plain connections, and one with a key that is authorised no longer.
    const Sender sender{"connection " + std::to_string(who), who == 3 ? "key" : "", {}, ""};
    handler.handle(sender, input.substr(0, size), state, now);
    take_turn(handler, state, database, store, authenticator, now);
    input.remove_prefix(std::min(size, input.size()));
    now.steady_ms += 700;
    now.wall_ms += 700;
  }
  refusals.take_complaints();
}

}  // namespace tetfarm::fuzz
