/// The few operations on files that the store and the command line need, each durable and checked.
///
/// A file written here is either wholly there under its name or not there at all, also after a
/// power loss: temporary file in the same folder, fsync, rename, fsync of the folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tetfarm {

/// The whole file. @throws IoError (not_found when there is none).
std::string read_file(const std::filesystem::path& path);

/// `size` bytes from `offset` on; fewer where the file ends. @throws IoError (not_found when there
/// is none).
std::string read_part_of_file(const std::filesystem::path& path, std::uint64_t offset,
                              std::size_t size);

/// Size in bytes; nothing when there is no such file. @throws IoError for any other trouble.
std::optional<std::uint64_t> size_of_file(const std::filesystem::path& path);

/// Replaces or makes `path` in one step; a failing write leaves neither a new nor a temporary file.
/// @throws IoError (out_of_resources when the disk or the quota is full).
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Puts bytes behind the first `offset` bytes of a file in the making, which is made when missing.
/// Not durable by itself; when it fails the file has `offset` bytes again.
/// @pre the file has `offset` bytes.
/// @throws IoError (out_of_resources when the disk or the quota is full).
void append_to_file(const std::filesystem::path& path, std::uint64_t offset,
                    std::string_view bytes);

/// Gives the finished file `from` the name `to` durably: fsync, rename (over an older file), fsync
/// of the folder.
/// @pre both lie on the same file system.
/// @throws IoError (error_number EXDEV when they do not).
void publish_by_rename(const std::filesystem::path& from, const std::filesystem::path& to);

/// `to` becomes the same file as `from` by a hard link, or a durable copy where links cannot be
/// made. An older `to` is replaced in one step. The caller must not change either afterwards.
/// @throws IoError.
void link_or_copy_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes the folder and those above it; one that is there is fine. @throws IoError.
void make_folders(const std::filesystem::path& folder);

/// Removes a file; one that is not there is fine. @throws IoError.
void remove_file(const std::filesystem::path& path);

/// The system's folder for temporary files. @throws IoError where there is none.
std::filesystem::path temporary_folder();

/// A name that no other process on any host chooses: "STEM.PROCESS.RANDOM.tmp".
std::string unique_temp_name(std::string_view stem);

}  // namespace tetfarm
