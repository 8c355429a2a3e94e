/// UGRID in all its forms as the list of formats knows them.
#pragma once

#include <array>

#include "mesh/formats/list/format.h"
#include "mesh/formats/ugrid/export_ugrid.h"
#include "mesh/formats/ugrid/read_ugrid_surface.h"
#include "mesh/formats/ugrid/ugrid_source.h"

namespace tetfarm {

inline constexpr std::array ugrid_formats = {
    Format{{.name = "lb8.ugrid",
            .endings = {".lb8.ugrid"},
            .what = "UGRID",
            .integer_bits = 32,
            .is_of_tasks = true},
           {.read_surface = read_ugrid_surface,
            .open_mesh = open_ugrid_as<false, false>,
            .write_mesh = export_ugrid<false, false>,
            .write_beside = write_beside_ugrid}},
    Format{{.name = "b8.ugrid",
            .endings = {".b8.ugrid"},
            .what = "UGRID, big endian",
            .integer_bits = 32},
           {.read_surface = read_ugrid_surface,
            .open_mesh = open_ugrid_as<true, false>,
            .write_mesh = export_ugrid<true, false>,
            .write_beside = write_beside_ugrid}},
    Format{{.name = "lb8l.ugrid",
            .endings = {".lb8l.ugrid"},
            .what = "UGRID, 64-bit integers",
            .integer_bits = 64},
           {.read_surface = read_ugrid_surface,
            .open_mesh = open_ugrid_as<false, true>,
            .write_mesh = export_ugrid<false, true>,
            .write_beside = write_beside_ugrid}},
    Format{{.name = "b8l.ugrid",
            .endings = {".b8l.ugrid"},
            .what = "UGRID, 64-bit integers, big endian",
            .integer_bits = 64},
           {.read_surface = read_ugrid_surface,
            .open_mesh = open_ugrid_as<true, true>,
            .write_mesh = export_ugrid<true, true>,
            .write_beside = write_beside_ugrid}},
    Format{{.name = "lb4.ugrid",
            .endings = {".lb4.ugrid"},
            .what = "UGRID, 32-bit coordinates",
            .integer_bits = 32},
           {.read_surface = read_ugrid_surface}},
    Format{{.name = "b4.ugrid",
            .endings = {".b4.ugrid"},
            .what = "UGRID, 32-bit coordinates, big endian",
            .integer_bits = 32},
           {.read_surface = read_ugrid_surface}},
    Format{{.name = "ugrid", .endings = {".ugrid"}, .what = "UGRID, text", .integer_bits = 32},
           {.read_surface = read_ugrid_surface}}};

}  // namespace tetfarm
