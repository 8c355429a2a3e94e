#include "mesh/formats/openfoam/foam_files.h"

#include <algorithm>

#include "base/check.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

std::string header(const std::string& foam_class, const std::string& object,
                   const std::string& note, const std::string& location = "constant/polyMesh") {
  return "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       " +
         foam_class + ";\n" + (note.empty() ? "" : "    note        \"" + note + "\";\n") +
         "    location    \"" + location + "\";\n    object      " + object + ";\n}\n\n";
}

constexpr const char* control_text =
    "application     simpleFoam;\nstartFrom       startTime;\nstartTime       0;\n"
    "stopAt          endTime;\nendTime         1000;\ndeltaT          1;\n"
    "writeControl    timeStep;\nwriteInterval   100;\nwriteFormat     binary;\n";

constexpr const char* schemes_text =
    "// Schemes for the solver are for you to choose.\n"
    "ddtSchemes\n{\n    default         none;\n}\ngradSchemes\n{\n    default         Gauss "
    "linear;\n}\ndivSchemes\n{\n    default         none;\n}\nlaplacianSchemes\n{\n    default "
    "        none;\n}\ninterpolationSchemes\n{\n    default         linear;\n}\nsnGradSchemes\n{\n "
    "   default         none;\n}\n";

constexpr const char* solution_text =
    "// Solvers and tolerances are for you to choose.\nsolvers\n{\n}\n";

void write_unless_there(const std::filesystem::path& file, const std::string& text) {
  if (!std::filesystem::exists(file)) write_file_atomically(file, text);
}

}  // namespace

const char* foam_type(PatchType type) {
  switch (type) {
    case PatchType::wall:
      return "wall";
    case PatchType::symmetry:
      return "symmetry";
    default:
      return "patch";
  }
}

void write_foam_system(const std::filesystem::path& folder, std::size_t parts) {
  const std::filesystem::path system = folder / "system";
  make_folders(system);
  const auto put = [&system](const char* name, const std::string& text) {
    write_unless_there(system / name, header("dictionary", name, "", "system") + text);
  };
  put("controlDict", control_text);
  put("fvSchemes", schemes_text);
  put("fvSolution", solution_text);
  if (parts > 0) {
    put("decomposeParDict",
        "numberOfSubdomains " + std::to_string(parts) + ";\nmethod          scotch;\n");
  }
  write_unless_there(folder / "case.foam", "");
}

FoamList::FoamList(const std::filesystem::path& folder, const Kind& kind, std::int64_t records)
    : file_(folder / kind.object), record_bytes_(kind.record_bytes), records_(records) {
  const std::string head =
      header(kind.foam_class, kind.object, kind.note) + std::to_string(records) + "\n(\n";
  file_.write(0, head);
  first_ = next_ = std::ssize(head);
}

void FoamList::write(std::int64_t record, std::string_view bytes) {
  file_.write(first_ + record * record_bytes_, bytes);
}

void FoamList::append(std::string_view bytes) {
  file_.write(next_, bytes);
  next_ += std::ssize(bytes);
}

void FoamList::finish() {
  write(records_, ")\n");
  file_.finish();
}

std::int64_t foam_point_bytes(const NumberText& style) { return style.record_bytes(0, 3) + 2; }
std::int64_t foam_face_bytes(const NumberText& style, std::size_t most_corners) {
  return style.record_bytes(static_cast<int>(most_corners), 0) + 3;
}
std::int64_t foam_label_bytes(const NumberText& style) { return style.record_bytes(1, 0); }

void put_foam_point(NumberText& text, const Vec3& p) {
  text.words("(");
  for (const double x : {p.x, p.y, p.z}) text.real(x);
  text.words(")");
  text.end_record();
}

void put_foam_face(NumberText& text, const FaceNodes<std::int64_t>& nodes,
                   std::size_t most_corners) {
  TF_CHECK(nodes.size() <= most_corners);
  text.words(std::to_string(nodes.size()) + "(");
  for (const std::int64_t v : nodes) text.integer(v);
  text.words(")");
  const auto blanks = foam_face_bytes(text, most_corners) - foam_face_bytes(text, nodes.size());
  text.words(std::string(static_cast<std::size_t>(blanks), ' '));
  text.end_record();
}

void put_foam_label(NumberText& text, std::int64_t label) {
  text.integer(label);
  text.end_record();
}

void write_foam_boundary(const std::filesystem::path& folder,
                         const std::vector<FoamPatch>& patches) {
  std::string text =
      header("polyBoundaryMesh", "boundary", "") + std::to_string(patches.size()) + "\n(\n";
  for (const FoamPatch& patch : patches) {
    text += "    " + patch.name + "\n    {\n        type            " +
            (patch.processor < 0 ? patch.type : "processor") + ";\n        nFaces          " +
            std::to_string(patch.faces) + ";\n        startFace       " +
            std::to_string(patch.first_face) + ";\n";
    if (patch.processor >= 0) {
      text +=
          "        matchTolerance  0.0001;\n        transform       unknown;\n"
          "        myProcNo        " +
          std::to_string(patch.processor) + ";\n        neighbProcNo    " +
          std::to_string(patch.neighbour) + ";\n";
    }
    text += "    }\n";
  }
  write_file_atomically(folder / "boundary", text + ")\n");
}

void write_foam_zones(const std::filesystem::path& folder, const std::vector<std::string>& names,
                      const std::vector<FoamZoneRun>& runs) {
  constexpr std::int64_t labels_of_piece = 100'000;
  OutputFile file(folder / "cellZones");
  std::int64_t place = 0;
  const auto append = [&](const std::string& text) {
    file.write(place, text);
    place += std::ssize(text);
  };
  append(header("regIOobject", "cellZones", "") + std::to_string(names.size()) + "\n(\n");
  for (std::size_t zone = 0; zone < names.size(); ++zone) {
    std::int64_t cells = 0;
    for (const FoamZoneRun& run : runs) cells += run.zone == zone ? run.count : 0;
    append(names[zone] + "\n{\n    type cellZone;\n    cellLabels List<label>\n" +
           std::to_string(cells) + "\n(\n");
    for (const FoamZoneRun& run : runs) {
      if (run.zone != zone) continue;
      const std::int64_t last = run.first + run.count;
      for (std::int64_t begin = run.first; begin < last; begin += labels_of_piece) {
        std::string labels;
        const std::int64_t end = std::min(begin + labels_of_piece, last);
        for (std::int64_t cell = begin; cell < end; ++cell) labels += std::to_string(cell) + "\n";
        append(labels);
      }
    }
    append(")\n;\n}\n");
  }
  append(")\n");
  file.finish();
}

}  // namespace tetfarm
