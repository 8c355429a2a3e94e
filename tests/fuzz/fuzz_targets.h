// What is fed with bytes that nobody checked: each takes any input, and ends the process when
// something that must hold does not. libFuzzer calls them (preset `fuzz`), and replay_test.cpp
// with the inputs that are kept in tests/fuzz/corpus.
#pragma once

#include <string_view>

namespace tetfarm::fuzz {

/// Messages to a coordinator, each after two bytes: 14 bits of length, 2 of who speaks. No message
/// ends it, and the invariants of its state hold after each. The store is an empty one with the id
/// "fuzz".
void wire(std::string_view input);

/// A job file: it is refused with an error of ours, or its canonical text gives the same job.
void job_file(std::string_view input);

/// A surface file of one of the formats, by the first byte modulo their number: it is refused with
/// an error of ours, or its triangles have vertices that are there.
void surface(std::string_view input);

/// A finished mesh in one of the formats, by the first byte modulo their number: it is refused with
/// an error of ours, or its parts hold together and `check_mesh` says what it thinks of them.
void mesh(std::string_view input);

/// A file of a mesh of the plane, of fields or of loops, by the first byte modulo their number: it
/// is refused with an error of ours, or it can be checked and written.
void plane(std::string_view input);

/// FLITE's sources: refused with an error of ours, or they may stand in a job file.
void flite_sources(std::string_view input);

/// A surface of up to 128 triangles: it is mended, what was mended needs no more of it and can be
/// remeshed; or what is left is told, or it is refused with an error of ours.
void bodies(std::string_view input);

/// One of the files that tasks read, by the first byte modulo the number of kinds; the checksum is
/// put right, so that what it guards is reached too.
void artifact(std::string_view input);

}  // namespace tetfarm::fuzz
