#include "dashboard/surface_answers.h"

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/surface_file.h"
#include "tests/base/temp_folder.h"
#include "tests/dashboard/fake_farm.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// A job whose store has the sub-domains that a test adds, and its surface.
class SurfacesOfAFarm : public ::testing::Test {
 protected:
  SurfacesOfAFarm() { farm_.files = folder_.path(); }

  wire::Artifact keep(const std::string& name, const std::string& bytes) {
    write_file_atomically(folder_.path() / name, bytes);
    wire::Artifact file;
    file.set_hash(name);
    file.set_size(bytes.size());
    return file;
  }
  wire::SubdomainLine& add(std::uint64_t path, const std::string& state, const std::string& hash,
                           const std::string& bytes) {
    const wire::Artifact file = keep(hash, bytes);
    wire::SubdomainLine& line = farm_.subdomains.emplace_back();
    line.set_path(path);
    line.set_state(state);
    line.set_hash(file.hash());
    line.set_size(file.size());
    return line;
  }
  static std::string sphere_bytes(int levels = 3) {
    return subdomain_to_bytes(root_subdomain(shapes::sphere({0, 0, 0}, 1, levels)));
  }
  nlohmann::json list() { return nlohmann::json::parse(answers_.list("job-1", farm_)); }
  ApiAnswer surface(std::uint64_t path, std::uint32_t triangles = 1024) {
    ApiRequest request;
    request.subject = ApiSubject::surface;
    request.job = "job-1";
    request.number = path;
    request.triangles = triangles;
    return answers_.surface(request, farm_);
  }
  /// The exit code of what is refused; 0 when it is not.
  int refusal(std::uint64_t path) {
    try {
      surface(path);
    } catch (const Error& error) {
      return static_cast<int>(error.code());
    }
    return 0;
  }
  static std::uint32_t triangles_in(const ApiAnswer& answer) {
    std::uint32_t count = 0;
    std::memcpy(&count, answer.body->data() + 16, sizeof count);
    return count;
  }

  const TempFolder folder_;
  FakeFarm farm_;
  std::int64_t now_ms_ = 0;
  SurfaceAnswers answers_{[this] { return now_ms_; }};
};

TEST_F(SurfacesOfAFarm, are_those_that_are_neither_cut_nor_joined) {
  add(1, "cut", "a", "");
  add(2, "leaf", "b", sphere_bytes()).set_meshed(true);
  add(3, "open", "c", "");
  add(5, "joined", "d", "");
  std::filesystem::remove(folder_.path() / "c");
  const nlohmann::json told = list();
  ASSERT_EQ(told["surfaces"].size(), 2U);
  EXPECT_EQ(told["surfaces"][0]["path"], 2);
  EXPECT_EQ(told["surfaces"][0]["place"], "L");
  EXPECT_EQ(told["surfaces"][0]["meshed"], true);
  EXPECT_EQ(told["surfaces"][0]["bytes"], sphere_bytes().size());
  EXPECT_EQ(told["surfaces"][0]["is_there"], true);
  EXPECT_EQ(told["surfaces"][1]["is_there"], false);
  EXPECT_EQ(told["left_out"], 0);
  EXPECT_EQ(told["sees_files"], true);
}

TEST_F(SurfacesOfAFarm, have_few_triangles_and_their_patches) {
  SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 3);
  sphere.patch_names = {"far", "near"};
  sphere.patch_of_triangle.assign(sphere.triangles.size(), 1);
  farm_.surface = keep("s", surface_to_bytes(sphere));
  add(1, "open", "a", subdomain_to_bytes(root_subdomain(sphere)));
  EXPECT_EQ(list()["patches"], (nlohmann::json{"far", "near"}));
  const ApiAnswer all = surface(1, 2048);
  EXPECT_EQ(all.status, 200);
  EXPECT_EQ(all.form, ApiForm::bytes);
  EXPECT_EQ(triangles_in(all), sphere.triangles.size());
  std::int32_t last_piece = 0;
  std::memcpy(&last_piece, all.body->data() + all.body->size() - 4, sizeof last_piece);
  EXPECT_EQ(last_piece, 1);
  const ApiAnswer few = surface(1, 256);
  EXPECT_LE(triangles_in(few), 256U);
  EXPECT_LT(few.body->size(), all.body->size());
}

TEST_F(SurfacesOfAFarm, have_unknown_patches_where_the_jobs_surface_is_gone) {
  farm_.surface.set_hash("gone");
  farm_.surface.set_size(10);
  add(1, "leaf", "a", sphere_bytes());
  EXPECT_EQ(list()["patches"].size(), 0U);
  const ApiAnswer answer = surface(1);
  std::int32_t last_piece = 0;
  std::memcpy(&last_piece, answer.body->data() + answer.body->size() - 4, sizeof last_piece);
  EXPECT_EQ(last_piece, -3);
}

TEST_F(SurfacesOfAFarm, are_made_once_for_all_who_ask) {
  add(1, "leaf", "a", sphere_bytes());
  const ApiAnswer once = surface(1);
  std::filesystem::remove(folder_.path() / "a");
  now_ms_ += 1'000'000;
  EXPECT_EQ(surface(1).body, once.body);
  EXPECT_EQ(farm_.times("TREE"), 2) << "what is there is asked again";
}

TEST_F(SurfacesOfAFarm, are_refused_where_the_file_is_gone_too_large_or_damaged) {
  add(1, "leaf", "a", sphere_bytes());
  add(2, "leaf", "b", sphere_bytes());
  std::filesystem::remove(folder_.path() / "b");
  add(4, "leaf", "c", "").set_size(largest_shown_file + 1);
  std::string damaged = sphere_bytes();
  damaged[damaged.size() / 2] ^= 1;
  add(5, "leaf", "d", damaged);
  add(6, "leaf", "e", sphere_bytes().substr(0, 100));
  EXPECT_EQ(refusal(1), 0);
  EXPECT_EQ(refusal(2), 5);
  EXPECT_EQ(refusal(3), 5) << "there is none";
  EXPECT_EQ(refusal(4), 6);
  EXPECT_THROW(surface(5), CorruptFile);
  EXPECT_THROW(surface(6), CorruptFile);
}

TEST_F(SurfacesOfAFarm, are_none_where_the_store_is_not_seen) {
  add(1, "leaf", "a", sphere_bytes());
  farm_.files.clear();
  EXPECT_EQ(list()["sees_files"], false);
  EXPECT_EQ(list()["surfaces"][0]["is_there"], false);
  EXPECT_EQ(refusal(1), 5);
}

TEST_F(SurfacesOfAFarm, are_at_most_two_thousand) {
  for (std::uint64_t path = 4096; path < 4096 + 2100; ++path) {
    wire::SubdomainLine& line = farm_.subdomains.emplace_back();
    line.set_path(path);
    line.set_state("leaf");
    line.set_hash("gone");
  }
  const nlohmann::json told = list();
  EXPECT_EQ(told["surfaces"].size(), 2'000U);
  EXPECT_EQ(told["left_out"], 100);
}

}  // namespace
}  // namespace tetfarm
