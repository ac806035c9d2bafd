#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// One file of a zip archive, unpacked.
struct ZipMember {
  std::string name;
  std::string bytes;
};

/// Every member of an archive in memory, in the order of its directory: stored or deflated, with
/// the end record of zip64 where there is one. Lengths, checksums and places are those of the
/// directory, and all are checked. `file` is what errors begin with. InputError "FILE: NAME: …" for
/// a damaged or encrypted member, another method, a name that stands twice, and members that unpack
/// to more than 1 GiB together.
std::vector<ZipMember> unzip(std::string_view archive, const std::string& file);

/// What the members of an archive are called, from its directory alone. InputError as unzip(), of
/// the directory.
std::vector<std::string> zip_names(std::string_view archive, const std::string& file);

/// An archive of members that are stored, all from the first of January 1980: the same members give
/// the same bytes. Names are UTF-8; at most 65535 members and 4 GiB, else InputError.
std::string zipped(const std::vector<ZipMember>& members, const std::string& file);

}  // namespace morphe::files
