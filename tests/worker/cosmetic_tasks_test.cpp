// The tasks of cosmetics across cuts one after the other, without coordinator or processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "mesh/artifacts/element_file.h"
#include "mesh/formats/registry/read_global_mesh.h"
#include "mesh/job_file/job_file.h"
#include "tests/base/temp_folder.h"
#include "tests/support/mesh_report.h"
#include "tests/support/shapes.h"
#include "tests/worker/task_chain.h"
#include "worker/assemble_task.h"
#include "worker/cosmetic_task.h"
#include "worker/decompose_task.h"
#include "worker/element_input.h"
#include "worker/extract_task.h"
#include "worker/inspect_task.h"
#include "worker/mesh_task.h"
#include "worker/number_task.h"
#include "worker/order_task.h"
#include "worker/run_task.h"
#include "worker/write_task.h"

namespace tetfarm {
namespace {

using Files = std::map<std::string, wire::Artifact>;
using test::off_of;
using Parameters = std::map<std::string, std::string>;

struct Turn {
  std::int32_t colour = 0;
  std::vector<std::uint64_t> neighbours;
};

std::map<std::uint64_t, Turn> turns_of(const std::string& order) {
  std::map<std::uint64_t, Turn> turns;
  std::istringstream lines(order);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::uint64_t heap = 0;
    words >> heap;
    words >> turns[heap].colour;
    for (std::uint64_t other = 0; words >> other;) turns[heap].neighbours.push_back(other);
  }
  return turns;
}

/// A ball cut into four, meshed, with its order.
class CosmeticTasks : public ::testing::Test {
 protected:
  CosmeticTasks() {
    JobFile job;
    job.name = "ball";
    job.surface = "ball.off";
    job.subdomains = 4;
    job_ = publish(to_toml(job));
    const auto ball = publish(off_of(shapes::sphere({0, 0, 0}, 1, 3)));
    const wire::Done inspected = run(inspect_task, 0, {{"job", job_}, {"input_surface", ball}});
    surface_ = output(inspected, "surface");
    spacing_ = output(inspected, "spacing");
    cut(1, 4, output(inspected, "root"));
    Files all;
    for (const auto& [heap, leaf] : leaves_) all["subdomain:" + std::to_string(heap)] = leaf;
    order_ = run(order_task, 0, all);
    turns_ = turns_of(order_.texts().at("order"));
    for (const auto& [heap, leaf] : leaves_) extract(heap);
  }

  wire::Artifact publish(const std::string& bytes) {
    const StoredArtifact stored = store_.publish(bytes);
    wire::Artifact artifact;
    artifact.set_hash(stored.hash);
    artifact.set_size(stored.size);
    return artifact;
  }

  wire::Envelope try_to_run(const TaskBody& body, std::uint64_t path, const Files& inputs,
                            const Parameters& parameters = {}) {
    wire::Assign assign;
    assign.set_path(path);
    for (const auto& [name, artifact] : inputs) {
      wire::Artifact& input = *assign.add_inputs();
      input = artifact;
      input.set_name(name);
    }
    assign.mutable_parameters()->insert(parameters.begin(), parameters.end());
    return run_task(
        store_, assign, body, [](const wire::Doing&) {}, is_without_shared_store_);
  }

  wire::Done run(const TaskBody& body, std::uint64_t path, const Files& inputs,
                 const Parameters& parameters = {}) {
    const wire::Envelope result = try_to_run(body, path, inputs, parameters);
    EXPECT_TRUE(result.has_done()) << result.failed().message();
    return result.done();
  }

  static wire::Artifact output(const wire::Done& done, const std::string& name) {
    for (const wire::Artifact& artifact : done.outputs()) {
      if (artifact.name() == name) return artifact;
    }
    ADD_FAILURE() << "no output " << name;
    return {};
  }

  void cut(std::uint64_t heap, int parts, const wire::Artifact& subdomain) {
    if (parts > 1) {
      const wire::Done done = run(decompose_task, heap,
                                  {{"job", job_}, {"subdomain", subdomain}, {"spacing", spacing_}},
                                  {{"left_parts", std::to_string(parts / 2)},
                                   {"right_parts", std::to_string(parts - parts / 2)},
                                   {"work", "1000"}});
      table_ += "cut " + std::to_string(heap) + " " +
                std::to_string(std::int64_t(done.numbers().at("interdomain_nodes"))) + "\n";
      cut(2 * heap, parts / 2, output(done, "left"));
      cut(2 * heap + 1, parts / 2, output(done, "right"));
      return;
    }
    leaves_[heap] = subdomain;
    const wire::Done done =
        run(mesh_task, heap, {{"job", job_}, {"subdomain", subdomain}, {"spacing", spacing_}},
            {{"work", "1000"}});
    meshes_[heap] = output(done, "mesh");
    table_ += "leaf " + std::to_string(heap) + " " +
              std::to_string(std::int64_t(done.numbers().at("interior_nodes"))) + " " +
              std::to_string(std::int64_t(done.numbers().at("tets"))) + "\n";
  }

  void extract(std::uint64_t heap) {
    const Files inputs = {{"subdomain", leaves_.at(heap)},
                          {"mesh", meshes_.at(heap)},
                          {"shared", output(order_, "shared:" + std::to_string(heap))}};
    extracted_[heap] = output(run(extract_task, heap, inputs), "elements");
  }

  wire::Envelope try_turn(std::uint64_t heap) {
    const Turn& turn = turns_.at(heap);
    Files inputs = {{"spacing", spacing_}, {"own", extracted_.at(heap)}};
    std::string colours = std::to_string(heap) + " " + std::to_string(turn.colour) + "\n";
    for (const std::uint64_t other : turn.neighbours) {
      const std::int32_t colour = turns_.at(other).colour;
      colours += std::to_string(other) + " " + std::to_string(colour) + "\n";
      if (colour < turn.colour) {
        inputs["had_turn:" + std::to_string(other)] = mended_.at(other);
      } else {
        inputs["waits:" + std::to_string(other)] = extracted_.at(other);
      }
    }
    return try_to_run(cosmetic_task, heap, inputs, {{"colours", colours}});
  }

  wire::Done give_turn(std::uint64_t heap) {
    const wire::Envelope result = try_turn(heap);
    EXPECT_TRUE(result.has_done()) << result.failed().message();
    mended_[heap] = output(result.done(), "elements");
    return result.done();
  }

  void give_all_turns() {
    for (std::int32_t colour = 0; colour < 4; ++colour) {
      for (const auto& [heap, turn] : turns_) {
        if (turn.colour == colour) give_turn(heap);
      }
    }
  }

  wire::Done assembled() { return run(assemble_task, 0, written()); }

  /// What assembling needs.
  Files written() {
    Files files;
    for (const auto& [heap, leaf] : leaves_) {
      files["core:" + std::to_string(heap)] = extracted_.at(heap);
      files["elements:" + std::to_string(heap)] = mended_.at(heap);
    }
    const Parameters order = {{"order", order_.texts().at("order")}};
    Parameters with_table = order;
    with_table["table"] = table_;
    Files to_number = files;
    to_number["surface"] = surface_;
    Files to_assemble = {{"job", job_}, {"surface", surface_}};
    to_assemble["numbering"] = output(run(number_task, 0, to_number, with_table), "numbering");
    for (const auto& [heap, leaf] : leaves_) {
      Files to_write = files;
      to_write["job"] = job_;
      to_write["subdomain"] = leaf;
      to_write["mesh"] = meshes_.at(heap);
      to_write["surface"] = surface_;
      to_write["numbering"] = to_assemble.at("numbering");
      const Parameters colours = {{"colours", order_.texts().at("order")}};
      const wire::Done written = run(write_task, heap, to_write, colours);
      to_assemble["portion:" + std::to_string(heap)] = output(written, "portion");
      to_assemble["tets:" + std::to_string(heap)] = output(written, "tets");
    }
    return to_assemble;
  }

  static Files without_tets(Files files) {
    std::erase_if(files, [](const auto& file) { return file.first.starts_with("tets:"); });
    return files;
  }

  void empty_scratch() {
    for (const auto& entry : std::filesystem::directory_iterator(store_.scratch_folder())) {
      std::filesystem::remove(entry.path());
    }
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  wire::Artifact job_;
  wire::Artifact surface_;
  wire::Artifact spacing_;
  std::string table_;
  std::map<std::uint64_t, wire::Artifact> leaves_;
  std::map<std::uint64_t, wire::Artifact> meshes_;
  std::map<std::uint64_t, wire::Artifact> extracted_;
  std::map<std::uint64_t, wire::Artifact> mended_;
  wire::Done order_;
  bool is_without_shared_store_ = false;
  std::map<std::uint64_t, Turn> turns_;
};

TEST_F(CosmeticTasks, make_one_valid_mesh_with_the_surface_as_it_was) {
  ASSERT_EQ(leaves_.size(), 4U);
  give_all_turns();
  const wire::Done done = assembled();
  const std::filesystem::path path = folder_.path() / "ball.vtkhdf";
  std::filesystem::copy_file(store_.path_of(output(done, "ball.vtkhdf").hash()), path);
  const MeshReport report = report_on(read_global_mesh(path));
  EXPECT_TRUE(report.complaints.empty()) << report.complaints.front();
  EXPECT_EQ(report.digest.hex(), done.texts().at("digest"));
  EXPECT_EQ(report.boundary_triangles, 1280);
  EXPECT_EQ(report.subdomains, 4);
}

TEST_F(CosmeticTasks, what_leaves_wrote_into_the_common_file_is_not_read_or_written_again) {
  give_all_turns();
  const Files files = written();
  const wire::Done done = run(assemble_task, 0, without_tets(files));
  const std::string hash = output(done, "ball.vtkhdf").hash();
  EXPECT_NO_THROW(store_.verify(hash, output(done, "ball.vtkhdf").size()));
  EXPECT_TRUE(std::filesystem::is_empty(store_.scratch_folder()));
  // The file went away with the result: it is made anew, which takes the tets.
  EXPECT_TRUE(try_to_run(assemble_task, 0, without_tets(files)).has_failed());
  EXPECT_EQ(output(run(assemble_task, 0, files), "ball.vtkhdf").hash(), hash);
}

TEST_F(CosmeticTasks, a_worker_without_the_store_writes_the_same_portions_and_the_same_mesh) {
  give_all_turns();
  const Files files = written();
  const wire::Done done = run(assemble_task, 0, files);
  empty_scratch();
  is_without_shared_store_ = true;
  const Files apart = written();
  for (const auto& [name, artifact] : files) {
    EXPECT_EQ(apart.at(name).hash(), artifact.hash()) << name;
  }
  EXPECT_TRUE(std::filesystem::is_empty(store_.scratch_folder()));
  const wire::Done other = run(assemble_task, 0, apart);
  EXPECT_EQ(output(other, "ball.vtkhdf").hash(), output(done, "ball.vtkhdf").hash());
  EXPECT_EQ(other.texts().at("digest"), done.texts().at("digest"));
}

TEST_F(CosmeticTasks, every_leaf_keeps_its_elements_but_for_those_at_the_cuts) {
  give_all_turns();
  for (const auto& [heap, leaf] : leaves_) {
    ElementFile before(store_.path_of(extracted_.at(heap).hash()), "extracted");
    ElementFile after(store_.path_of(mended_.at(heap).hash()), "mended");
    double at_first = 0;
    for (const auto& section : before.head().sections) {
      const auto place = std::lower_bound(section.sharers.begin(), section.sharers.end(), heap);
      at_first += double(section.tets[std::size_t(place - section.sharers.begin())]);
    }
    double at_last = double(before.head().sections.front().tets.front());
    for (const auto& section : after.head().sections) {
      const auto place = std::lower_bound(section.sharers.begin(), section.sharers.end(), heap);
      at_last += double(section.tets[std::size_t(place - section.sharers.begin())]);
    }
    EXPECT_NEAR(at_last / at_first, 1, 0.05);
  }
}

TEST_F(CosmeticTasks, a_turn_reads_what_it_shares_and_no_core) {
  const std::uint64_t first = turns_.begin()->first;
  ASSERT_EQ(turns_.begin()->second.colour, 0);
  const wire::Done done = give_turn(first);
  double bytes_of_files = static_cast<double>(extracted_.at(first).size());
  for (const std::uint64_t other : turns_.at(first).neighbours) {
    bytes_of_files += static_cast<double>(extracted_.at(other).size());
  }
  EXPECT_EQ(done.numbers().at("bytes_of_files"), bytes_of_files);
  EXPECT_LT(done.numbers().at("bytes_read"), bytes_of_files);
  // Damage of a neighbour's core is none of its business.
  const auto file_of = [&](std::uint64_t heap) {
    return ElementFile(store_.path_of(extracted_.at(heap).hash()), "elements");
  };
  const auto& neighbours = turns_.begin()->second.neighbours;
  const auto with_core = std::find_if(
      neighbours.begin(), neighbours.end(),
      [&](std::uint64_t heap) { return file_of(heap).head().sections.front().size > 100; });
  ASSERT_NE(with_core, neighbours.end()) << "no core has elements";
  const std::uint64_t neighbour = *with_core;
  const std::filesystem::path path = store_.path_of(extracted_.at(neighbour).hash());
  const ElementFile file(path, "elements");
  const auto offset = file.head().sections.front().offset;
  const auto damage = [&path](std::uint64_t place) {
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    std::fstream stream(path, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(place));
    stream.put('\x55');
  };
  damage(offset + 50);
  const wire::Envelope again = try_turn(first);
  ASSERT_TRUE(again.has_done()) << again.failed().message();
  EXPECT_EQ(output(again.done(), "elements").hash(), mended_.at(first).hash());
  // Damage of a section that it shares is: whoever made the file has to run again.
  damage(*file.head().find({first, neighbour}) == 0
             ? 0
             : file.head().sections[*file.head().find({first, neighbour})].offset + 50);
  const wire::Envelope refused = try_turn(first);
  ASSERT_TRUE(refused.has_failed());
  ASSERT_EQ(refused.failed().damaged_inputs_size(), 1);
  EXPECT_EQ(refused.failed().damaged_inputs(0), extracted_.at(neighbour).hash());
}

TEST_F(CosmeticTasks, the_same_turn_gives_the_same_bytes) {
  give_all_turns();
  const auto once = mended_;
  mended_.clear();
  give_all_turns();
  for (const auto& [heap, artifact] : once) EXPECT_EQ(mended_.at(heap).hash(), artifact.hash());
}

TEST(ElementInput, the_last_turn_of_a_section_is_that_of_the_highest_colour_below) {
  const Colours colours = colours_of("4 0 5 6\n5 1 4\n6 2 4\n");
  EXPECT_EQ(last_before({4, 5, 6}, colours, 2), 5U);
  EXPECT_EQ(last_before({4, 5, 6}, colours, 1), 4U);
  EXPECT_EQ(last_before({4, 5, 6}, colours, 0), 0U);
  EXPECT_EQ(last_turn({4, 5, 6}, colours), 6U);
  EXPECT_THROW(last_turn({4, 7}, colours), Error);
  EXPECT_THROW(colours_of("4 x\n"), Error);
}

}  // namespace
}  // namespace tetfarm
