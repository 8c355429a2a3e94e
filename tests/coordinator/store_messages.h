// What a client and a worker say first to a coordinator over a store.
#pragma once

#include <string>

#include "proto/wire.h"
#include "store/artifact_store.h"
#include "tests/base/temp_folder.h"

namespace tetfarm::test {

inline void add_file(wire::Artifact& file, const std::string& name, const StoredArtifact& from) {
  file.set_name(name);
  file.set_hash(from.hash);
  file.set_size(from.size);
}

/// A store of its own, and messages of those who see it.
class WithStore {
 protected:
  wire::Envelope hello(std::uint64_t task = 0, std::uint64_t attempt = 0) const {
    wire::Envelope envelope;
    envelope.mutable_hello()->set_host("here");
    envelope.mutable_hello()->set_nonce("one process");
    envelope.mutable_hello()->set_store_probe(store_.probe());
    envelope.mutable_hello()->set_running_task(task);
    envelope.mutable_hello()->set_running_attempt(attempt);
    return envelope;
  }
  wire::Envelope submission(const std::string& key) const {
    const StoredArtifact surface = store_.publish("solid wing");
    wire::Envelope envelope;
    wire::Submit& submit = *envelope.mutable_submit();
    submit.set_job_toml("[geometry]\nsurface = \"a.stl\"\n");
    submit.set_name("wing");
    submit.set_key(key);
    add_file(*submit.add_inputs(), "input_surface", surface);
    return envelope;
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
};

}  // namespace tetfarm::test
