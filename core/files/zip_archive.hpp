#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// An uncompressed member of a zip archive.
struct ZipMember {
  std::string name, bytes;
};

/// Unpacks all members of an archive in memory, in the order of its directory. Members may be
/// stored or deflated; a zip64 end record is supported. Lengths, checksums and offsets are taken
/// from the directory, and all are checked. `file` begins the error messages. Throws InputError
/// "FILE: NAME: …" for a damaged or encrypted member, another compression method, a name that
/// occurs twice, and members of more than 1 GiB in total.
std::vector<ZipMember> unzip(std::string_view archive, const std::string& file);

/// Returns the names in an archive's directory; throws InputError if the directory is damaged.
std::vector<std::string> zip_names(std::string_view archive, const std::string& file);

/// Creates an archive of uncompressed members, all dated the first of January 1980, so that equal
/// members give equal bytes. Names are UTF-8. Throws InputError from 65535 members or 3 GiB on.
std::string zip(const std::vector<ZipMember>& members, const std::string& file);

}  // namespace morphe::files
