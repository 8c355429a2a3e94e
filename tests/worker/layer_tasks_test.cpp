// The tasks of a job with layers, one after the other.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "base/array_index.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/quality/mesh_check.h"
#include "tasks/ratio_histogram.h"
#include "tests/mesh/assemble/expect_feet.h"
#include "tests/mesh/layers/boxes_with_planes.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/support/shapes.h"
#include "tests/worker/task_chain.h"
#include "worker/grow_task.h"

namespace tetfarm {
namespace {

using test::TaskChain;
using testing::HasSubstr;

class LayerTasks : public TaskChain {
 protected:
  /// Five layers inside a ball.
  static JobFile layered_job(std::int64_t subdomains) {
    JobFile job = job_of(subdomains);
    job.spacing_default = 0.3;
    JobLayers layers;
    layers.patches = {"*"};
    layers.first_height = 0.02;
    layers.count = 5;
    job.layers = {layers};
    return job;
  }

  /// The chunks of an inspected job, by heap number.
  Files chunks_of(const wire::Envelope& inspected) {
    Files chunks;
    for (const wire::Artifact& artifact : inspected.done().outputs()) {
      if (!artifact.name().starts_with("layers:")) continue;
      chunks[artifact.name().substr(artifact.name().find(':') + 1)] = artifact;
    }
    return chunks;
  }

  /// All tasks but for the last, and what that is given.
  Files prepared(const JobFile& job, const SurfaceMesh& given) {
    return prepared(job, inspect(job, given));
  }

  Files prepared(const JobFile& job, const wire::Envelope& inspected) {
    EXPECT_TRUE(inspected.has_done()) << inspected.failed().message();
    const wire::Artifact surface = output(inspected, "surface");
    const wire::Artifact spacing = output(inspected, "spacing");
    std::string table;
    files_ = {{"job", publish(to_toml(job))}, {"surface", surface}, {"spacing", spacing}};
    const auto parts = static_cast<std::int64_t>(inspected.done().numbers().at("parts"));
    if (!job.layers.empty()) files_["top_heights"] = output(inspected, "top_heights");
    EXPECT_TRUE(settle(output(inspected, "root"), 2, parts, spacing, table, files_))
        << last_.failed().message();
    const wire::Envelope numbered =
        run(number_task, {{"surface", surface}, {"layer_table", output(inspected, "layer_table")}},
            {{"table", table}});
    files_["numbering"] = output(numbered, "numbering");
    Files all = written(files_);
    for (const auto& [heap, chunk] : chunks_of(inspected)) {
      last_ = grow(chunk);
      all["portion:" + heap] = output(last_, "portion");
      all["tets:" + heap] = output(last_, "cells");
    }
    return all;
  }

  wire::Envelope grow(const wire::Artifact& chunk) {
    return run(grow_task, {{"job", files_.at("job")},
                           {"surface", files_.at("surface")},
                           {"numbering", files_.at("numbering")},
                           {"layers", chunk}});
  }

  void expect_sound(const wire::Envelope& assembled, const std::string& name) {
    const std::string path = folder_ + "/" + name;
    std::filesystem::copy_file(store_.path_of(output(assembled, name).hash()), path,
                               std::filesystem::copy_options::overwrite_existing);
    const auto source = open_mesh(path, folder_);
    const MeshCheckResult result = check_mesh(*source);
    EXPECT_THAT(result.complaints, testing::IsEmpty()) << name;
    EXPECT_EQ(result.digest.hex(), assembled.done().texts().at("digest")) << name;
    if (name.ends_with(".vtkhdf")) test::FeetOfMesh(*source).expect_sound();
  }

  /// Of the five layers and of nothing else.
  void expect_marks(const std::string& path) const {
    const auto source = open_mesh(path, folder_);
    EXPECT_EQ(source->cell_marks(), std::vector{CellMark::layer});
    std::map<std::int32_t, int> cells_of_layer;
    for (std::size_t i = 0; i < source->size(); ++i) {
      const NumberedPart part = source->part(i);
      const std::vector<std::int32_t>& layers = part.marks[CellMark::layer];
      ASSERT_EQ(std::ssize(layers), cells_of(part));
      for (std::size_t c = 0; c < layers.size(); ++c) {
        EXPECT_EQ(layers[c] == 0, c < part.tets.size()) << "tets are beyond the layers";
        ++cells_of_layer[layers[c]];
      }
    }
    expect_feet_on_the_boundary(*source);
    cells_of_layer.erase(0);
    EXPECT_EQ(cells_of_layer,
              (std::map<std::int32_t, int>{{1, 320}, {2, 320}, {3, 320}, {4, 320}, {5, 320}}));
  }

  /// Its nodes are the feet, and no others.
  static void expect_feet_on_the_boundary(const MeshSource& mesh) {
    std::set<std::int64_t> boundary;
    std::set<std::int64_t> feet;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      const NumberedPart part = mesh.part(i);
      for (const Triangle& face : part.faces) {
        for (const std::int32_t v : face) boundary.insert(part.local2global[at(v)]);
      }
      feet.insert(part.feet.foot.begin(), part.feet.foot.end());
    }
    feet.erase(no_foot);
    EXPECT_EQ(feet, boundary);
  }

  Files files_;
};

TEST_F(LayerTasks, make_one_sound_mesh_of_layers_and_tets) {
  const SurfaceMesh ball = shapes::sphere({1, 2, 3}, 1, 2);
  for (const std::int64_t subdomains : {1, 3}) {
    const wire::Envelope assembled = run(assemble_task, prepared(layered_job(subdomains), ball));
    ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
    const auto& numbers = assembled.done().numbers();
    EXPECT_EQ(numbers.at("prisms"), 5 * 320);
    EXPECT_EQ(numbers.at("elements"), numbers.at("tets") + numbers.at("prisms"));
    EXPECT_GT(numbers.at("min_dihedral_deg"), 1) << "of the tets beyond the layers";
    EXPECT_NEAR(numbers.at("volume"), domain_volume(ball), 1e-9);
    expect_sound(assembled, "ball.vtkhdf");
    expect_sound(assembled, "ball.lb8.ugrid");
    expect_marks(folder_ + "/ball.vtkhdf");
  }
}

/// Of each triangle of the top the tet that stands on it, in whichever sub-domain.
TEST_F(LayerTasks, tell_how_the_tets_on_top_fit_to_the_last_prisms) {
  const SurfaceMesh ball = shapes::sphere({1, 2, 3}, 1, 2);
  for (const std::int64_t subdomains : {1, 3}) {
    RatioHistogram jumps;
    told_by_write_ = [&jumps](const wire::Envelope& written) {
      const auto& texts = written.done().texts();
      if (texts.contains("top_jumps")) {
        jumps.add(RatioHistogram::from(texts.at("top_jumps")).value());
      }
    };
    prepared(layered_job(subdomains), ball);
    EXPECT_EQ(jumps.count(), 320) << subdomains;
    EXPECT_GT(jumps.quantile(0.5).value(), 1);
    EXPECT_LT(jumps.quantile(0.5).value(), 10);
    const auto jacobians = RatioHistogram::from(last_.done().texts().at("scaled_jacobians"));
    EXPECT_EQ(jacobians.value().count(), 5 * 320);
  }
}

TEST_F(LayerTasks, end_on_planes_with_quads_that_close_the_mesh) {
  for (const std::int64_t subdomains : {1, 3}) {
    JobFile job = layered_job(subdomains);
    job.name = "box";
    job.surface = "box.obj";
    job.layers[0].patches = {"floor"};
    const std::string box = test::obj_of(test::box_with_patches({0, 0, 0}, {1, 1, 1}, 6));
    const wire::Envelope inspected =
        run(inspect_task, {{"job", publish(to_toml(job))}, {"input_surface", publish(box)}});
    const wire::Envelope assembled = run(assemble_task, prepared(job, inspected));
    ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
    const auto& numbers = assembled.done().numbers();
    EXPECT_EQ(numbers.at("prisms"), 5 * 72);
    EXPECT_EQ(numbers.at("quads"), 5 * 4 * 6);
    EXPECT_NEAR(numbers.at("volume"), 1, 1e-12);
    expect_sound(assembled, "box.vtkhdf");
    expect_sound(assembled, "box.lb8.ugrid");
  }
}

TEST_F(LayerTasks, fan_round_the_edges_of_a_body_in_one_sound_mesh) {
  for (const double fan_angle : {60.0, no_fan_angle}) {
    JobFile job = layered_job(3);
    job.name = "cube";
    job.surface = "cube.obj";
    job.layers[0].patches = {"body"};
    job.layers[0].fan_angle = fan_angle;
    const std::string cube = test::obj_of(test::cube_in_box(4));
    const wire::Envelope inspected =
        run(inspect_task, {{"job", publish(to_toml(job))}, {"input_surface", publish(cube)}});
    const wire::Envelope assembled = run(assemble_task, prepared(job, inspected));
    ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
    const auto& numbers = assembled.done().numbers();
    EXPECT_NEAR(numbers.at("volume"), 6 * 6 * 6 - 2 * 2 * 2, 1e-9);
    EXPECT_EQ(numbers.at("pyramids") > 0, fan_angle < no_fan_angle);
    const double jacobian = last_.done().numbers().at("min_scaled_jacobian");
    EXPECT_EQ(jacobian > 0.7, fan_angle < no_fan_angle) << jacobian;
    expect_sound(assembled, "cube.vtkhdf");
    expect_sound(assembled, "cube.lb8.ugrid");
  }
}

TEST_F(LayerTasks, fan_round_edges_that_end_at_a_plane_in_one_sound_mesh) {
  JobFile job = layered_job(3);
  job.name = "pillar";
  job.surface = "pillar.obj";
  job.layers[0].patches = {"body"};
  const std::string pillar = test::obj_of(test::pillar_in_box());
  const wire::Envelope inspected =
      run(inspect_task, {{"job", publish(to_toml(job))}, {"input_surface", publish(pillar)}});
  const wire::Envelope assembled = run(assemble_task, prepared(job, inspected));
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  const auto& numbers = assembled.done().numbers();
  EXPECT_NEAR(numbers.at("volume"), 6 * 6 * 5 - 2 * 2 * 2, 1e-9);
  EXPECT_EQ(numbers.at("quads"), 5 * 16 + 4 * 4 * 2);
  expect_sound(assembled, "pillar.vtkhdf");
  expect_sound(assembled, "pillar.lb8.ugrid");
}

TEST_F(LayerTasks, in_tets_make_a_sound_mesh_of_tets_alone_beside_planes_and_round_edges) {
  JobFile job = layered_job(3);
  job.name = "pillar";
  job.surface = "pillar.obj";
  job.layers[0].patches = {"body"};
  const std::string pillar = test::obj_of(test::pillar_in_box());
  const auto assembled_with = [&](const std::string& elements) {
    job.layers[0].elements = elements;
    const wire::Envelope inspected =
        run(inspect_task, {{"job", publish(to_toml(job))}, {"input_surface", publish(pillar)}});
    return run(assemble_task, prepared(job, inspected));
  };
  const wire::Envelope undivided = assembled_with("prisms");
  const wire::Envelope assembled = assembled_with("tets");
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  const auto& numbers = assembled.done().numbers();
  const auto& before = undivided.done().numbers();
  EXPECT_EQ(numbers.at("elements"), numbers.at("tets"));
  EXPECT_EQ(numbers.at("prisms"), 0);
  EXPECT_EQ(numbers.at("pyramids"), 0);
  EXPECT_FALSE(numbers.contains("quads"));
  EXPECT_EQ(numbers.at("tets"),
            before.at("tets") + 2 * before.at("pyramids") + 3 * before.at("prisms"));
  EXPECT_EQ(numbers.at("nodes"), before.at("nodes"));
  EXPECT_EQ(numbers.at("min_dihedral_deg"), before.at("min_dihedral_deg")) << "beyond the layers";
  EXPECT_NEAR(numbers.at("volume"), 6 * 6 * 5 - 2 * 2 * 2, 1e-9);
  EXPECT_EQ(numbers.at("surface_triangles_below_5_deg"), 0) << "the sides of layers do not count";
  EXPECT_FALSE(last_.done().numbers().contains("min_scaled_jacobian"));
  expect_sound(assembled, "pillar.vtkhdf");
  expect_sound(assembled, "pillar.lb8.ugrid");
}

TEST_F(LayerTasks, place_their_cells_in_the_file_of_all_where_all_is_counted) {
  prepared(layered_job(1), shapes::sphere({0, 0, 0}, 1, 2));
  const Portion portion = portion_from_bytes(bytes(output(last_, "portion")), "portion");
  EXPECT_EQ(portion.placed.size(), 2U) << "nodes of cells, and layers";
  EXPECT_EQ(portion.others[ElementType::prism], 5 * 320);
  EXPECT_EQ(portion.shapes.all.tets, 0);
}

TEST_F(LayerTasks, refuse_a_damaged_chunk) {
  const JobFile job = layered_job(1);
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  prepared(job, ball);
  const wire::Artifact chunk = chunks_of(inspect(job, ball)).at("3");
  std::string broken = bytes(chunk);
  broken[broken.size() / 2] = static_cast<char>(broken[broken.size() / 2] ^ 1);
  const wire::Envelope refused = grow(publish(broken));
  ASSERT_TRUE(refused.has_failed());
  EXPECT_THAT(refused.failed().message(), HasSubstr("has a wrong checksum"));
}

TEST_F(LayerTasks, are_those_of_a_job_without_layers_where_nothing_can_grow) {
  JobFile job = layered_job(1);
  job.layers[0].first_height = 0.3;
  job.layers[0].count = 900;
  job.layers[0].growth = 1;
  job.layers[0].room = "stop";
  SurfaceMesh thin = shapes::box({0, 0, 0}, {1, 1, 0.01}, 2);
  const wire::Envelope inspected = inspect(job, thin);
  ASSERT_TRUE(inspected.has_done()) << inspected.failed().message();
  EXPECT_THAT(chunks_of(inspected), testing::IsEmpty());
  const Subdomain root = subdomain_from_bytes(bytes(output(inspected, "root")), "root");
  EXPECT_EQ(root.path.heap, 1U);
  EXPECT_EQ(inspected.done().numbers().at("layers_none"), thin.triangles.size());
}

TEST_F(LayerTasks, that_absorb_have_their_feet_on_the_inner_side) {
  for (const char* elements : {"prisms", "tets"}) {
    JobFile job = job_of(3);
    job.spacing_default = 0.3;
    JobPml pml;
    pml.patches = {"*"};
    pml.layers = 3;
    pml.height = 0.125;
    pml.elements = elements;
    job.pml = pml;
    const Vec3 middle = {1, 2, 3};
    const wire::Envelope assembled =
        run(assemble_task, prepared(job, shapes::sphere(middle, 1, 2)));
    ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
    expect_sound(assembled, "ball.vtkhdf");
    const auto mesh = open_mesh(folder_ + "/ball.vtkhdf", folder_);
    std::map<std::int32_t, int> nodes_of_depth;
    for (std::size_t i = 0; i < mesh->size(); ++i) {
      const NumberedPart part = mesh->part(i);
      for (std::size_t v = 0; v < part.nodes.size(); ++v) {
        const std::int32_t depth = part.feet.depth[v];
        const double radius = norm(part.nodes[v] - middle);
        if (depth == no_foot) {
          EXPECT_LT(radius, 1);
        } else {
          EXPECT_NEAR(radius, 1 + 0.125 * depth, 1e-12);
        }
        ++nodes_of_depth[depth];
      }
    }
    EXPECT_EQ(nodes_of_depth.rbegin()->first, 3) << "those of the outer boundary";
  }
}

TEST_F(LayerTasks, that_absorb_in_blocks_tell_solvers_by_tags_where_each_cell_is) {
  JobFile job = job_of(2);
  job.spacing_default = 0.5;
  JobPml pml;
  pml.patches = {"*"};
  pml.layers = 3;
  pml.height = 0.125;
  pml.corners = "block";
  job.pml = pml;
  const Vec3 low = {-1, 0, 1};
  const Vec3 high = {1, 1.5, 2};
  const wire::Envelope assembled = run(assemble_task, prepared(job, shapes::box(low, high, 4)));
  ASSERT_TRUE(assembled.has_done()) << assembled.failed().message();
  expect_sound(assembled, "ball.vtkhdf");
  const auto mesh = open_mesh(folder_ + "/ball.vtkhdf", folder_);
  std::map<std::int32_t, int> cells_of_axes;
  for (std::size_t i = 0; i < mesh->size(); ++i) {
    const NumberedPart part = mesh->part(i);
    EXPECT_EQ(cells_of(part), std::ssize(part.tets));
    for (std::size_t c = 0; c < part.tets.size(); ++c) {
      Vec3 middle;
      for (const std::int32_t v : part.tets[c]) middle += 0.25 * part.nodes[at(v)];
      std::int32_t axes = 0;
      for (int axis = 0; axis < 3; ++axis) {
        axes |= middle[axis] < low[axis] || middle[axis] > high[axis] ? 1 << axis : 0;
      }
      ASSERT_EQ(part.marks[CellMark::pml_axes][c], axes);
      ASSERT_EQ(part.marks[CellMark::pml_depth][c] > 0, axes > 0);
      ++cells_of_axes[axes];
    }
  }
  for (const int axis : {1, 2, 4}) EXPECT_EQ(cells_of_axes[axis], 2 * 32 * 3 * 3);
  for (const int axes : {3, 5, 6}) EXPECT_EQ(cells_of_axes[axes], 4 * 4 * 6 * 3 * 3);
  EXPECT_EQ(cells_of_axes[7], 8 * 6 * 27);
}

}  // namespace
}  // namespace tetfarm
