#include "mesh/formats/vtkhdf/write_vtkhdf.h"

#include "base/error.h"
#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

namespace tetfarm {
namespace {

class VtkhdfWriter : public GlobalMeshWriter {
 public:
  VtkhdfWriter(const std::filesystem::path& path, std::span<const VtkhdfCounts> parts,
               const VtkhdfNames& names)
      : frame_(path.string() + ".frame", parts, names), file_(path, OutputFile::Start::empty) {}

  void add(const NumberedPart& part) override {
    const auto number = static_cast<std::size_t>(part.number);
    if (vtkhdf_counts(part) != frame_.counts(number)) {
      throw Error(ExitCode::failed, "a sub-domain has different counts from those announced");
    }
    frame_.add(part);
    write_vtkhdf_cells(frame_.places(), frame_.before(number), part, &file_);
    write_vtkhdf_points(frame_.places(), frame_.before(number), part, file_);
  }

  void finish() override {
    frame_.finish(file_);
    file_.finish();
  }

 private:
  VtkhdfFrame frame_;
  OutputFile file_;
};

}  // namespace

std::unique_ptr<GlobalMeshWriter> write_vtkhdf(const std::filesystem::path& path,
                                               std::span<const VtkhdfCounts> parts,
                                               const VtkhdfNames& names) {
  return std::make_unique<VtkhdfWriter>(path, parts, names);
}

}  // namespace tetfarm
