// Writes the inputs that fuzzing starts from: fuzz_write_seeds FOLDER makes FOLDER/wire and so on.
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "base/file_system.h"
#include "base/hash.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/assemble/numbering_file.h"
#include "mesh/core/subdomain.h"
#include "mesh/job_file/job_file.h"
#include "mesh/layers/layer_chunk_file.h"
#include "mesh/spacing/spacing_field.h"
#include "proto/file_chunks.h"
#include "proto/wire.h"
#include "store/artifact_store.h"
#include "tasks/failure_cause.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_box.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& bytes) {
  make_folders(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string framed(const std::vector<wire::Envelope>& envelopes) {
  std::string bytes;
  for (const wire::Envelope& envelope : envelopes) {
    const std::string message = encode(envelope);
    bytes += static_cast<char>(message.size() % 256);
    bytes += static_cast<char>(message.size() / 256);
    bytes += message;
  }
  return bytes;
}

wire::Envelope with(void (*fill)(wire::Envelope&)) {
  wire::Envelope envelope;
  fill(envelope);
  return envelope;
}

/// A worker that does not see the store: an input comes, an output goes, then the attempt is over.
void write_files(const fs::path& folder, std::vector<wire::Envelope> messages) {
  const auto add = [&messages](auto* body, const std::string& hash) {
    body->set_task(1);
    body->set_attempt(1);
    body->set_hash(hash);
  };
  add(messages.emplace_back().mutable_fetch_file(),
      hash128(messages.front().submit().job_toml()).hex());
  const std::string hash = hash128("output").hex();
  wire::OfferFile* offer = messages.emplace_back().mutable_offer_file();
  add(offer, hash);
  offer->set_size(6);
  for (const char* bytes : {"outpux", "output"}) {
    wire::FileChunk* chunk = messages.emplace_back().mutable_file_chunk();
    add(chunk, hash);
    fill_chunk(*chunk, bytes);
  }
  messages.emplace_back().mutable_cancel()->set_job("job-1");
  add(messages.emplace_back().mutable_offer_file(), hash);
  write(folder / "files", framed(messages));
}

/// A job, a worker of the same connection (the length of its Hello says which), its first task
/// done.
void write_messages(const fs::path& folder) {
  const auto submit = with([](wire::Envelope& e) {
    e.mutable_submit()->set_job_toml("[geometry]\nsurface = \"a.stl\"\n");
    e.mutable_submit()->set_key("k");
  });
  const auto hello = with([](wire::Envelope& e) {
    e.mutable_hello()->set_store_probe("fuzz");
    e.mutable_hello()->set_host("h");
  });
  const auto ready = with([](wire::Envelope& e) { e.mutable_ready(); });
  const auto beat = with([](wire::Envelope& e) {
    e.mutable_heartbeat()->set_task(1);
    e.mutable_heartbeat()->set_attempt(1);
    e.mutable_heartbeat()->mutable_doing()->set_stage("check");
    e.mutable_heartbeat()->mutable_doing()->set_done(3);
  });
  const auto done = with([](wire::Envelope& e) {
    e.mutable_done()->set_task(1);
    e.mutable_done()->set_attempt(1);
    for (const char* name : {"surface", "spacing", "root"}) {
      wire::Artifact& output = *e.mutable_done()->add_outputs();
      output.set_name(name);
      output.set_hash(std::string(32, 'a'));
      output.set_size(1);
    }
    (*e.mutable_done()->mutable_numbers())["parts"] = 2;
  });
  const auto failed = with([](wire::Envelope& e) {
    e.mutable_failed()->set_task(1);
    e.mutable_failed()->set_attempt(1);
    e.mutable_failed()->set_cause(on_wire(FailureCause::damaged_input));
    e.mutable_failed()->set_message("m");
    e.mutable_failed()->add_damaged_inputs(std::string(32, 'b'));
  });
  const auto status = with([](wire::Envelope& e) { e.mutable_status_request(); });
  const auto cancel = with([](wire::Envelope& e) { e.mutable_cancel()->set_job("job-1"); });
  const auto goodbye = with([](wire::Envelope& e) { e.mutable_goodbye(); });
  const auto path = with(
      [](wire::Envelope& e) { e.mutable_submit()->set_surface_path("/dev/shm/../../etc/passwd"); });
  write_files(folder, {submit, hello, ready});
  write(folder / "done", framed({submit, hello, ready, beat, done, ready, status}));
  write(folder / "failed", framed({submit, hello, ready, failed, ready, goodbye}));
  write(folder / "cancelled", framed({submit, hello, ready, cancel, beat, done, status}));
  write(folder / "path", framed({path, status}));
}

void write_job_files(const fs::path& folder) {
  JobFile job;
  job.name = "job";
  job.surface = "wing.stl";
  write(folder / "plain", to_toml(job));
  job.outer_kind = "box";
  job.outer_factor = 3;
  job.regions = {{{0, 0, 0}, "core", false}, {{1, 2, 3}, "", true}};
  JobSource::Corner corner;
  corner.at = {1, 0.5, -2};
  corner.spacing = 0.1;
  corner.inner = 1;
  corner.outer = 2;
  for (std::size_t corners = 1; corners <= 3; ++corners) {
    job.sources.push_back({std::vector<JobSource::Corner>(corners, corner), 0});
  }
  JobLayers layers;
  layers.patches = {"wing_*", "tip"};
  layers.first_height = 1e-4;
  layers.growth_cap = 1.5;
  layers.acceleration = 1.05;
  layers.count = 20;
  job.layers = {layers};
  layers = {};
  layers.patches = {"t?p"};
  layers.y_plus = 1;
  layers.reynolds = 6e6;
  layers.length = 1;
  layers.total_height = 0.01;
  job.layers.push_back(layers);
  job.formats = {"vtkhdf", "lb8.ugrid"};
  write(folder / "rich", to_toml(job));
}

/// Each after the byte of its kind, without the checksum that the target puts there.
void write_artifacts(const fs::path& folder) {
  const SurfaceMesh surface = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
  const auto put = [&](const char* name, char kind, std::string bytes, std::size_t cut) {
    bytes.resize(bytes.size() - cut);
    write(folder / name, kind + bytes);
  };
  put("surface", 0, surface_to_bytes(surface), 16);
  const Numbering numbering = number_globally(
      surface, "cut 1 5\nleaf 2 6 30 7\nleaf 3 1 1 5\ndropped 1 1 2\ndropped 2 4 1\n");
  put("numbering", 0, numbering_to_bytes(numbering), 16);
  put("numbering_text", 0, numbering_to_text(numbering), 0);
  put("subdomain", 1, subdomain_to_bytes(root_subdomain(surface)), 16);
  TetMesh mesh;
  mesh.boundary_nodes = 4;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}};
  mesh.tets = {{0, 1, 2, 4}};
  put("mesh", 2, tet_mesh_to_bytes(mesh), 16);
  put("shared", 3, shared_nodes_to_bytes({}), 16);
  put("spacing", 4, make_spacing_field(surface, {}).to_bytes(), 0);
  ElementFileHead head;
  head.path.heap = 1;
  put("elements", 5, elements_to_bytes(head, {}, CoreElements{1, {0, 2}, {1}}), 0);
  put("stl", 6,
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid a\n",
      0);
  put("obj", 7, "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\nf -1 -2 -3\n", 0);
  put("off", 8, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 0);
  put("msh2", 9,
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
      "$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n",
      0);
  put("msh4", 9,
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n"
      "1 0 0\n0 1 0\n$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n",
      0);
  put("keys", 11, std::string(64, 'a') + " worker one # x\n", 0);
  const test::LayeredBox box;
  put("layers", 12, layer_chunk_to_bytes(chunks_of(box.plan, box.surface, 20).at(0)), 16);
  const test::LayeredPillar pillar;
  put("fans", 12, layer_chunk_to_bytes(chunks_of(pillar.plan, pillar.surface, 60).at(0)), 16);
  const test::LayeredPillar in_tets(5, true);
  LayerChunk listed = chunks_of(in_tets.plan, in_tets.surface, 60).at(0);
  for (ChunkLine& line : listed.lines) {
    line.line.law = law_of_heights(std::vector<double>{0.02, 0.03, 0.03, 0.04, 0.04});
  }
  put("heights", 12, layer_chunk_to_bytes(listed), 16);
}

}  // namespace
}  // namespace tetfarm

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "fuzz_write_seeds FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  tetfarm::write_messages(folder / "wire");
  tetfarm::write_job_files(folder / "job_file");
  tetfarm::write_artifacts(folder / "artifact");
  return 0;
}
