#pragma once

#include <cstdint>

#include "core/files/disk.hpp"

namespace morphe::store {

/// HDF5 does not survive a write that fails: closing what it could not flush crashes the library.
/// This driver, the plain one otherwise (same calls, same bytes), never fails towards HDF5: it
/// remembers that something did not reach the disk, for hdf5_output_error() to tell.
/// Has a file be written to `disk` by this driver: `access` is its list of access properties.
void write_through_output_driver(std::int64_t access, files::Disk& disk);
/// errno of the first write of an open file that failed, 0 if none did.
int hdf5_output_error(std::int64_t file);
/// Leaves it in `error` when the file is closed, which writes, too.
void report_hdf5_output_error(std::int64_t file, int& error);

}  // namespace morphe::store
