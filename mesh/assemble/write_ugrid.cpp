#include "mesh/assemble/write_ugrid.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <limits>
#include <numeric>

#include "base/error.h"

namespace tetfarm {
namespace {

static_assert(std::endian::native == std::endian::little, "lb8 is little endian");

constexpr std::int64_t header_bytes = 7 * 4;
constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

/// A file that is filled at several places at once.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw IoError("cannot make the file", path_.string(), errno);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  template <class T>
  void write(std::int64_t offset, const std::vector<T>& values) {
    const char* data = reinterpret_cast<const char*>(values.data());
    std::size_t left = values.size() * sizeof(T);
    while (left > 0) {
      const ssize_t done = ::pwrite(descriptor_, data, left, offset);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) throw IoError("cannot write", path_.string(), done < 0 ? errno : ENOSPC);
      data += done;
      offset += done;
      left -= static_cast<std::size_t>(done);
    }
  }

  void finish() {
    if (::fsync(descriptor_) != 0) throw IoError("cannot write", path_.string(), errno);
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) throw IoError("cannot write", path_.string(), errno);
  }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

std::int32_t from_one(std::int64_t number) { return static_cast<std::int32_t>(number + 1); }

class UgridWriter : public GlobalMeshWriter {
 public:
  UgridWriter(const std::filesystem::path& path, std::int64_t nodes, std::int64_t triangles,
              std::int64_t tets)
      : file_(path),
        next_triangle_(header_bytes + nodes * 24),
        next_patch_(next_triangle_ + triangles * 12),
        next_tet_(next_patch_ + triangles * 4) {
    const auto count = [](std::int64_t n) { return static_cast<std::int32_t>(n); };
    file_.write(0,
                std::vector<std::int32_t>{count(nodes), count(triangles), 0, count(tets), 0, 0, 0});
  }

  void add(const NumberedPart& part) override {
    add_nodes(part);
    const auto number = [&](std::int32_t local) {
      return from_one(part.local2global[static_cast<std::size_t>(local)]);
    };
    std::vector<std::int32_t> triangles;
    triangles.reserve(part.faces.size() * 3);
    for (const auto& [a, b, c] : part.faces) {
      triangles.insert(triangles.end(), {number(a), number(c), number(b)});
    }
    std::vector<std::int32_t> patches;
    for (const std::int32_t patch : part.patch_of_face) patches.push_back(from_one(patch));
    std::vector<std::int32_t> tets;
    tets.reserve(part.tets.size() * 4);
    for (const Tet& tet : part.tets) {
      for (const std::int32_t v : tet) tets.push_back(number(v));
    }
    append(next_triangle_, triangles);
    append(next_patch_, patches);
    append(next_tet_, tets);
  }

  void finish() override { file_.finish(); }

 private:
  void append(std::int64_t& place, const std::vector<std::int32_t>& values) {
    file_.write(place, values);
    place += std::ssize(values) * 4;
  }

  /// Nodes with consecutive numbers are written together; those on interfaces once for each part
  /// that has them.
  void add_nodes(const NumberedPart& part) {
    std::vector<std::size_t> by_number(part.nodes.size());
    std::iota(by_number.begin(), by_number.end(), std::size_t{0});
    std::sort(by_number.begin(), by_number.end(), [&](std::size_t a, std::size_t b) {
      return part.local2global[a] < part.local2global[b];
    });
    std::vector<Vec3> run;
    std::int64_t first = 0;
    for (const std::size_t v : by_number) {
      const std::int64_t number = part.local2global[v];
      if (number != first + std::ssize(run)) {
        file_.write(header_bytes + first * 24, run);
        run.clear();
        first = number;
      }
      run.push_back(part.nodes[v]);
    }
    file_.write(header_bytes + first * 24, run);
  }

  OutputFile file_;
  std::int64_t next_triangle_;
  std::int64_t next_patch_;
  std::int64_t next_tet_;
};

}  // namespace

std::unique_ptr<GlobalMeshWriter> write_ugrid(const std::filesystem::path& path,
                                              const Numbering& numbering,
                                              std::int64_t boundary_triangles) {
  static_assert(sizeof(Vec3) == 24);
  if (numbering.nodes > most || numbering.tets > most || boundary_triangles > most) {
    throw Error(ExitCode::failed,
                "the mesh is too large for lb8.ugrid, whose counts end at 2147483647: " +
                    std::to_string(numbering.nodes) + " nodes, " + std::to_string(numbering.tets) +
                    " tets; use the format vtkhdf");
  }
  return std::make_unique<UgridWriter>(path, numbering.nodes, boundary_triangles, numbering.tets);
}

std::string mapbc_text(const std::vector<std::string>& patch_names) {
  std::string text = std::to_string(patch_names.size()) + '\n';
  for (std::size_t i = 0; i < patch_names.size(); ++i) {
    text += std::to_string(i + 1) + " 3000 " + patch_names[i] + '\n';
  }
  return text;
}

}  // namespace tetfarm
