/// The tasks of a job one after the other, without coordinator or processes.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "mesh/artifacts/artifact_file.h"
#include "mesh/core/validate.h"
#include "mesh/formats/registry/read_global_mesh.h"
#include "mesh/job_file/job_file.h"
#include "tests/support/mesh_report.h"
#include "worker/assemble_task.h"
#include "worker/decompose_task.h"
#include "worker/inspect_task.h"
#include "worker/mesh_task.h"
#include "worker/number_task.h"
#include "worker/run_task.h"
#include "worker/write_task.h"

namespace tetfarm::test {

inline std::string off_of(const SurfaceMesh& surface) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << surface.vertices.size() << " " << surface.triangles.size() << " 0\n";
  for (const Vec3& p : surface.vertices) text << p.x << " " << p.y << " " << p.z << "\n";
  for (const Triangle& t : surface.triangles) {
    text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  return text.str();
}

/// Every test has a store of its own.
class TaskChain : public ::testing::Test {
 protected:
  using Files = std::map<std::string, wire::Artifact>;

  static std::string new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "tasks-XXXXXX").string();
    return ::mkdtemp(name.data());
  }
  ~TaskChain() override { std::filesystem::remove_all(folder_); }

  wire::Artifact publish(const std::string& bytes) {
    const StoredArtifact stored = store_.publish(bytes);
    wire::Artifact artifact;
    artifact.set_hash(stored.hash);
    artifact.set_size(stored.size);
    return artifact;
  }

  wire::Envelope run(const TaskBody& body, const Files& inputs,
                     const std::map<std::string, std::string>& parameters = {}) {
    wire::Assign assign;
    for (const auto& [name, artifact] : inputs) {
      wire::Artifact& input = *assign.add_inputs();
      input = artifact;
      input.set_name(name);
    }
    assign.mutable_parameters()->insert(parameters.begin(), parameters.end());
    return run_task(store_, assign, body, [](const wire::Doing&) {});
  }

  wire::Artifact output(const wire::Envelope& result, const std::string& name) {
    for (const wire::Artifact& artifact : result.done().outputs()) {
      if (artifact.name() == name) return artifact;
    }
    ADD_FAILURE() << "no output " << name << ": " << result.failed().message();
    return {};
  }

  std::string bytes(const wire::Artifact& artifact) {
    return store_.read(artifact.hash(), artifact.size());
  }

  wire::Envelope inspect(const JobFile& job, const SurfaceMesh& surface) {
    return run(inspect_task,
               {{"job", publish(to_toml(job))}, {"input_surface", publish(off_of(surface))}});
  }

  /// The sub-domain and what becomes of it: lines of the table, files for assembly. False when a
  /// task failed; its answer is `last_`.
  bool settle(const wire::Artifact& subdomain, std::int64_t heap, std::int64_t parts,
              const wire::Artifact& spacing, std::string& table, Files& files) {
    const Files inputs = {{"job", files.at("job")}, {"subdomain", subdomain}, {"spacing", spacing}};
    if (parts > 1) {
      last_ = run(decompose_task, inputs,
                  {{"left_parts", std::to_string(parts / 2)},
                   {"right_parts", std::to_string(parts - parts / 2)},
                   {"work", "1000"}});
      if (!last_.has_done()) return false;
      if (last_.done().outputs_size() > 0) {
        const wire::Envelope cut = last_;
        const auto number = [&cut](const char* name) {
          return static_cast<std::int64_t>(cut.done().numbers().at(name));
        };
        table += "cut " + std::to_string(heap) + " " + std::to_string(number("interdomain_nodes")) +
                 "\n";
        const bool told = cut.done().numbers().contains("left_parts");
        const std::int64_t left = told ? number("left_parts") : parts / 2;
        const std::int64_t right = told ? number("right_parts") : parts - parts / 2;
        return settle(output(cut, "left"), 2 * heap, left, spacing, table, files) &&
               settle(output(cut, "right"), 2 * heap + 1, right, spacing, table, files);
      }
    }
    last_ = run(mesh_task, inputs, {{"work", "1000"}});
    if (!last_.has_done()) return false;
    const auto& numbers = last_.done().numbers();
    std::ostringstream line;
    line << "leaf " << heap << " " << numbers.at("interior_nodes") << " " << numbers.at("tets");
    table += line.str() + "\n";
    const Subdomain leaf = subdomain_from_bytes(bytes(subdomain), "leaf");
    EXPECT_EQ(leaf.path.heap, static_cast<std::uint64_t>(heap));
    const TetMesh mesh = tet_mesh_from_bytes(bytes(output(last_, "mesh")), leaf, "mesh");
    EXPECT_EQ(validate(mesh, leaf.triangles), std::vector<std::string>());
    files["subdomain:" + std::to_string(heap)] = subdomain;
    files["mesh:" + std::to_string(heap)] = output(last_, "mesh");
    return true;
  }

  /// What assembling needs: the portion of every leaf of which `files` has the mesh.
  Files written(const Files& files) {
    Files result = {{"job", files.at("job")},
                    {"surface", files.at("surface")},
                    {"numbering", files.at("numbering")}};
    for (const auto& [name, artifact] : files) {
      if (!name.starts_with("mesh:")) continue;
      const std::string heap = name.substr(5);
      Files given = {{"job", files.at("job")},
                     {"surface", files.at("surface")},
                     {"numbering", files.at("numbering")},
                     {"subdomain", files.at("subdomain:" + heap)},
                     {"mesh", artifact}};
      if (files.contains("top_heights")) given["top_heights"] = files.at("top_heights");
      last_ = run(write_task, given);
      if (told_by_write_) told_by_write_(last_);
      result["portion:" + heap] = output(last_, "portion");
      result["tets:" + heap] = output(last_, "tets");
    }
    return result;
  }

  /// All tasks of a job, one after the other. The answer of the last, or of the one that failed.
  wire::Envelope chain(const JobFile& job, const SurfaceMesh& given) {
    const wire::Envelope inspected = inspect(job, given);
    if (!inspected.has_done()) return inspected;
    const wire::Artifact surface = output(inspected, "surface");
    const wire::Artifact spacing = output(inspected, "spacing");
    std::string table;
    Files files = {{"job", publish(to_toml(job))}, {"surface", surface}, {"spacing", spacing}};
    const auto parts = static_cast<std::int64_t>(inspected.done().numbers().at("parts"));
    if (!settle(output(inspected, "root"), 1, parts, spacing, table, files)) return last_;
    const wire::Envelope numbered = run(number_task, {{"surface", surface}}, {{"table", table}});
    if (!numbered.has_done()) return numbered;
    files["numbering"] = output(numbered, "numbering");
    return run(assemble_task, written(files));
  }

  void expect_right_files(const wire::Envelope& assembled) {
    for (const char* name : {"ball.vtkhdf", "ball.lb8.ugrid"}) {
      const std::string path = folder_ + "/" + name;
      std::filesystem::remove(path);
      std::filesystem::copy_file(store_.path_of(output(assembled, name).hash()), path);
      const MeshReport report = report_on(read_global_mesh(path));
      EXPECT_TRUE(report.complaints.empty()) << report.complaints.front();
      EXPECT_EQ(report.digest.hex(), assembled.done().texts().at("digest")) << name;
    }
  }

  static JobFile job_of(std::int64_t subdomains) {
    JobFile job;
    job.name = "ball";
    job.surface = "ball.off";
    job.subdomains = subdomains;
    job.formats = {"vtkhdf", "lb8.ugrid"};
    return job;
  }

  std::string folder_ = new_folder();
  ArtifactStore store_{folder_};
  wire::Envelope last_;
  std::function<void(const wire::Envelope&)> told_by_write_;  ///< called with each answer of it
};

}  // namespace tetfarm::test
