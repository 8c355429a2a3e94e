#include "worker/leaf_inputs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/mesh/artifacts/surface_without_blocks.h"
#include "tests/support/shapes.h"
#include "tests/worker/task_chain.h"

namespace tetfarm {
namespace {

/// A cut box with needles, as far as its nodes are numbered. Surface and numbering have two blocks,
/// as there are many vertices that no triangle uses.
class LeafInputs : public test::TaskChain {
 protected:
  void SetUp() override {
    JobFile job = job_of(4);
    SurfaceMesh box = shapes::box({0, 0, 0}, {4, 4, 4}, 4);
    for (Vec3& v : box.vertices) {
      if (v == Vec3{2, 2, 4}) v.x = 2.999;
    }
    box.vertices.resize(1200, Vec3{5, 5, 5});
    const wire::Envelope inspected = inspect(job, box);
    files_ = {{"job", publish(to_toml(job))}, {"surface", output(inspected, "surface")}};
    std::string table;
    ASSERT_TRUE(
        settle(output(inspected, "root"), 1, 4, output(inspected, "spacing"), table, files_));
    ASSERT_NE(table.find("cut 1"), std::string::npos) << "it was to be cut";
    const wire::Envelope numbered =
        run(number_task, {{"surface", files_["surface"]}}, {{"table", table}});
    files_["numbering"] = output(numbered, "numbering");
  }

  SurfaceMesh surface() { return surface_from_bytes(bytes(files_["surface"]), "surface"); }
  Numbering numbering() { return numbering_from_bytes(bytes(files_["numbering"]), "numbering"); }

  /// What the write task of each leaf makes of those files.
  std::map<std::string, wire::Envelope> write_all(const wire::Artifact& surface,
                                                  const wire::Artifact& numbering) {
    std::map<std::string, wire::Envelope> results;
    for (const auto& [name, artifact] : files_) {
      if (!name.starts_with("mesh:")) continue;
      const std::string heap = name.substr(5);
      results[heap] = run(write_task, {{"job", files_["job"]},
                                       {"surface", surface},
                                       {"numbering", numbering},
                                       {"subdomain", files_["subdomain:" + heap]},
                                       {"mesh", artifact}});
    }
    return results;
  }

  void damage(const wire::Artifact& artifact, std::size_t place) {
    std::string damaged = bytes(artifact);
    damaged.at(place) = static_cast<char>(damaged.at(place) ^ 1);
    std::ofstream(store_.path_of(artifact.hash()), std::ios::binary) << damaged;
  }

  Files files_;
};

TEST_F(LeafInputs, of_earlier_versions_give_the_same_portions) {
  const auto usual = write_all(files_["surface"], files_["numbering"]);
  ASSERT_EQ(usual.size(), 4U);
  const wire::Artifact old_surface = publish(surface_without_blocks(surface()));
  const wire::Artifact old_numbering = publish(numbering_to_text(numbering()));
  bool is_any_forced = false;
  for (const auto& [surface, numbering] :
       {std::pair{old_surface, files_["numbering"]}, std::pair{files_["surface"], old_numbering},
        std::pair{old_surface, old_numbering}}) {
    for (const auto& [heap, result] : write_all(surface, numbering)) {
      const wire::Envelope& other = usual.at(heap);
      EXPECT_EQ(output(result, "portion").hash(), output(other, "portion").hash()) << heap;
      EXPECT_EQ(output(result, "tets").hash(), output(other, "tets").hash()) << heap;
      const auto& numbers = result.done().numbers();
      for (const auto& [name, value] : other.done().numbers()) {
        EXPECT_EQ(numbers.at(name), value) << name;
      }
      is_any_forced |= numbers.at("unforced_elements") < numbers.at("tets");
    }
  }
  EXPECT_TRUE(is_any_forced) << "else nothing is seen of the figures of the surface";
}

TEST_F(LeafInputs, that_are_damaged_are_told_apart) {
  const std::uint64_t triangles = SurfaceCounts{1200}.triangles_at() + 100;
  ASSERT_GT(bytes(files_["numbering"]).size(), 5000U);
  using Place = std::pair<const char*, std::uint64_t>;
  for (const auto& [name, place] : {Place{"surface", 20}, Place{"surface", triangles},
                                    Place{"numbering", 20}, Place{"numbering", 4900}}) {
    const std::string whole = bytes(files_[name]);
    damage(files_[name], place);
    for (const auto& [heap, result] : write_all(files_["surface"], files_["numbering"])) {
      ASSERT_TRUE(result.has_failed()) << name;
      ASSERT_EQ(result.failed().damaged_inputs_size(), 1) << name;
      EXPECT_EQ(result.failed().damaged_inputs(0), files_[name].hash());
    }
    std::ofstream(store_.path_of(files_[name].hash()), std::ios::binary) << whole;
  }
}

TEST_F(LeafInputs, that_are_missing_are_told_apart) {
  for (const char* name : {"surface", "numbering"}) {
    const std::string whole = bytes(files_[name]);
    std::filesystem::remove(store_.path_of(files_[name].hash()));
    for (const auto& [heap, result] : write_all(files_["surface"], files_["numbering"])) {
      ASSERT_TRUE(result.has_failed()) << name;
      ASSERT_EQ(result.failed().damaged_inputs_size(), 1) << name;
      EXPECT_EQ(result.failed().damaged_inputs(0), files_[name].hash());
    }
    std::ofstream(store_.path_of(files_[name].hash()), std::ios::binary) << whole;
  }
}

}  // namespace
}  // namespace tetfarm
