#include "mesh/formats/vtkhdf/write_vtkhdf.h"

#include "base/error.h"
#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

namespace tetfarm {
namespace {

class VtkhdfWriter : public GlobalMeshWriter {
 public:
  VtkhdfWriter(const std::filesystem::path& path, std::span<const VtkhdfCounts> parts,
               const VtkhdfNames& names)
      : parts_(parts.begin(), parts.end()),
        before_(before_each(parts)),
        frame_(path.string() + ".frame", parts, names),
        file_(path, OutputFile::Start::empty) {}

  void add(const NumberedPart& part) override {
    const auto number = static_cast<std::size_t>(part.number);
    const VtkhdfCounts& counts = parts_.at(number);
    if (vtkhdf_counts(part) != counts) {
      throw Error(ExitCode::failed, "a sub-domain has different counts from those announced");
    }
    frame_.add(part);
    write_vtkhdf_cells(frame_.places(), before_[number], part, &file_);
    write_vtkhdf_points(frame_.places(), before_[number], part, file_);
  }

  void finish() override {
    frame_.finish(file_);
    file_.finish();
  }

 private:
  std::vector<VtkhdfCounts> parts_;
  std::vector<VtkhdfBefore> before_;
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
