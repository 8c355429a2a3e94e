/// Which program this is: what another program has computed may differ.
#pragma once

#include <span>
#include <string>

namespace tetfarm {

/// The same for copies of one executable, another for each that was linked from other code: the
/// hash that the linker put into it, or, where it put none, the hash of the whole file. Cost:
/// nothing; without the linker's hash, reading the file. @throws IoError.
std::string program_identity();

/// The linker's hash, in hexadecimal digits, among the notes of an executable as they lie in memory
/// (ELF, all of a segment PT_NOTE): that of type 3 by "GNU". "": none.
std::string build_id_among(std::span<const char> notes);

}  // namespace tetfarm
