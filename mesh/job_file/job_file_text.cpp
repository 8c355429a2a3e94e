
#include "base/check.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/toml_text.h"

namespace tetfarm {
namespace {

std::string place(const Vec3& at) {
  return "[" + toml_number(at.x) + ", " + toml_number(at.y) + ", " + toml_number(at.z) + "]";
}

std::string corner_keys_of(const JobSource::Corner& corner, std::string_view between) {
  const std::string separator(between);
  return "at = " + place(corner.at) + separator + "spacing = " + toml_number(corner.spacing) +
         separator + "inner = " + toml_number(corner.inner) + separator +
         "outer = " + toml_number(corner.outer);
}

std::string solid_to_toml(const JobSource& source) {
  TF_CHECK(source.corners.size() == 2);
  const bool is_box = source.shape == JobSource::Shape::box;
  std::string text = is_box ? "kind = \"box\"\n" : "kind = \"cylinder\"\n";
  text += (is_box ? "low = " : "from = ") + place(source.corners[0].at) + "\n";
  text += (is_box ? "high = " : "to = ") + place(source.corners[1].at) + "\n";
  if (!is_box) {
    text +=
        "radius = [" + toml_number(source.radii[0]) + ", " + toml_number(source.radii[1]) + "]\n";
  }
  return text + "spacing = " + toml_number(source.corners[0].spacing) +
         "\nouter = " + toml_number(source.corners[0].outer) + "\n";
}

std::string source_to_toml(const JobSource& source) {
  TF_CHECK(!source.corners.empty() && source.corners.size() <= 3);
  std::string text = "\n[[source]]\n";
  if (source.shape != JobSource::Shape::hull) return text + solid_to_toml(source);
  const auto inline_corner = [&](std::size_t i) {
    return "{ " + corner_keys_of(source.corners.at(i), ", ") + " }";
  };
  switch (source.corners.size()) {
    case 1:
      return text + "kind = \"point\"\n" + corner_keys_of(source.corners[0], "\n") + "\n";
    case 2:
      return text + "kind = \"line\"\nfrom = " + inline_corner(0) + "\nto = " + inline_corner(1) +
             "\n";
    default:
      return text + "kind = \"triangle\"\ncorner = [\n  " + inline_corner(0) + ",\n  " +
             inline_corner(1) + ",\n  " + inline_corner(2) + ",\n]\n";
  }
}

/// "["a", "b"]".
std::string array_of(const std::vector<std::string>& texts) {
  std::string text = "[";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    text += (i == 0 ? "" : ", ") + quoted_toml(texts[i]);
  }
  return text + "]";
}

std::string array_of(const std::vector<double>& numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : ", ") + toml_number(numbers[i]);
  return text + "]";
}

/// What says how high its layers are, by a law.
std::string height_law_to_toml(const JobLayers& layers) {
  std::string text;
  if (layers.y_plus > 0) {
    text += "y_plus = " + toml_number(layers.y_plus) +
            "\nreynolds = " + toml_number(layers.reynolds) +
            "\nlength = " + toml_number(layers.length) + "\n";
  } else {
    text += "first_height = " + toml_number(layers.first_height) + "\n";
  }
  text += "growth = " + toml_number(layers.growth) + "\n";
  if (layers.growth_cap > 0) {
    text += "growth_cap = " + toml_number(layers.growth_cap) +
            "\nacceleration = " + toml_number(layers.acceleration) + "\n";
  }
  if (layers.total_height > 0) {
    text += "total_height = " + toml_number(layers.total_height) + "\n";
  } else {
    text += "count = " + (layers.count > 0 ? std::to_string(layers.count) : "\"isotropic\"") + "\n";
  }
  return text + "equal = " + std::to_string(layers.equal) + "\n";
}

std::string layers_to_toml(const JobLayers& layers) {
  std::string text = "\n[[layers]]\npatches = " + array_of(layers.patches) + "\n";
  text += layers.heights.empty() ? height_law_to_toml(layers)
                                 : "heights = " + array_of(layers.heights) + "\n";
  text += "room = " + quoted_toml(layers.room) + "\n";
  if (layers.step != 1) text += "step = " + std::to_string(layers.step) + "\n";
  if (layers.fan_angle != JobLayers{}.fan_angle) {
    text += "fan_angle = " + toml_number(layers.fan_angle) + "\n";
  }
  if (layers.elements != JobLayers{}.elements) {
    text += "elements = " + quoted_toml(layers.elements) + "\n";
  }
  return text;
}

std::string pml_to_toml(const JobPml& pml) {
  return "\n[[pml]]\npatches = " + array_of(pml.patches) +
         "\nlayers = " + std::to_string(pml.layers) +
         "\nheight = " + (pml.height > 0 ? toml_number(pml.height) : "\"spacing\"") +
         "\ncorners = " + quoted_toml(pml.corners) + "\nelements = " + quoted_toml(pml.elements) +
         "\n" + (pml.side == JobPml{}.side ? "" : "side = " + quoted_toml(pml.side) + "\n");
}

std::string patch_to_toml(const JobPatch& patch) {
  std::string text = "\n[patch." + quoted_toml(patch.glob) + "]\n";
  if (!patch.type.empty()) text += "type = " + quoted_toml(patch.type) + "\n";
  if (patch.size > 0) text += "size = " + toml_number(patch.size) + "\n";
  if (patch.growth > 0) text += "growth = " + toml_number(patch.growth) + "\n";
  return text;
}

/// Of [geometry], behind the surface.
std::string scale_to_toml(const JobFile& job) {
  if (!job.unit.empty()) return "unit = " + quoted_toml(job.unit) + "\n";
  return job.scale == 1 ? "" : "scale = " + toml_number(job.scale) + "\n";
}

std::string remeshing_to_toml(const JobRemeshing& remeshing) {
  std::string text = "\n[surface]\nremesh = true\nangle = " + toml_number(remeshing.angle) + "\n";
  if (remeshing.size > 0) text += "size = " + toml_number(remeshing.size) + "\n";
  if (remeshing.min_size > 0) text += "min_size = " + toml_number(remeshing.min_size) + "\n";
  if (remeshing.tolerance > 0) text += "tolerance = " + toml_number(remeshing.tolerance) + "\n";
  return text;
}

/// All digits of the number.
std::string symmetry_text(const AxisPlane& plane) {
  return std::string(1, "xyz"[plane.axis]) + "=" + toml_number(plane.height);
}

}  // namespace

std::string to_toml(const JobFile& job) {
  std::string text = "version = 1\nname = " + quoted_toml(job.name) +
                     "\n\n[geometry]\nsurface = " + quoted_toml(job.surface) + "\n";
  text += scale_to_toml(job);
  if (job.remeshing) text += remeshing_to_toml(*job.remeshing);
  text += "\n[domain]\nouter = " + quoted_toml(job.outer_kind) + "\n";
  if (job.outer_kind != "none") {
    text += "factor = " + toml_number(job.outer_factor) +
            "\nspacing = " + toml_number(job.outer_spacing) + "\n";
  }
  if (job.symmetry) text += "symmetry = " + quoted_toml(symmetry_text(*job.symmetry)) + "\n";
  for (const JobRegion& region : job.regions) {
    text += "\n[[region]]\nat = " + place(region.at) + "\nname = " + quoted_toml(region.name) +
            "\nvoid = " + (region.is_void ? "true" : "false") + "\n";
  }
  text += "\n[spacing]\ndefault = " + toml_number(job.spacing_default) +
          "\ngrowth = " + toml_number(job.growth) +
          "\nsurface = " + quoted_toml(job.inherit_surface ? "inherit" : "ignore") +
          "\nmax_elements = " + std::to_string(job.max_elements) + "\n";
  for (const JobSource& source : job.sources) text += source_to_toml(source);
  for (const JobLayers& layers : job.layers) text += layers_to_toml(layers);
  for (const JobPatch& patch : job.patches) {
    text += patch_to_toml(patch);
  }
  if (job.pml) text += pml_to_toml(*job.pml);
  text += "\n[decompose]\n";
  if (job.max_memory_bytes > 0) {
    text += "max_memory = " + quoted_toml(std::to_string(job.max_memory_bytes) + "B") + "\n";
  } else {
    text += "subdomains = " + std::to_string(job.subdomains) +
            "\ntarget_elements = " + std::to_string(job.target_elements) + "\n";
  }
  if (job.groups > 0) {
    text += "assimilate = { groups = " + std::to_string(job.groups) +
            ", method = " + quoted_toml(job.assimilate_method) + " }\n";
  }
  text += "plane = " + quoted_toml(job.plane) + "\n";
  text += "\n[mesh]\npoints = " + quoted_toml(job.points) +
          "\n\n[cosmetics]\nacross_cuts = " + (job.across_cuts ? "true" : "false") +
          "\n\n[quality]\nmin_dihedral = " + toml_number(job.min_dihedral_deg) +
          "\nmin_unforced_dihedral = " + toml_number(job.min_unforced_dihedral_deg) +
          "\n\n[output]\nformats = " + array_of(job.formats) + "\n";
  if (!job.keep.empty()) text += "keep = " + quoted_toml(job.keep) + "\n";
  return text;
}

}  // namespace tetfarm
