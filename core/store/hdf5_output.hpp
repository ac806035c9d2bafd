#pragma once

#include <cstdint>

#include "core/files/disk.hpp"

namespace morphe::store {

/// Sets file access properties such that the file is written to `disk` by a driver of our own. The
/// HDF5 library crashes when it closes data that it could not write. This driver makes the same
/// calls and writes the same bytes as the default one, but never reports a failure to HDF5: it
/// keeps the error for hdf5_output_error().
void write_through_output_driver(std::int64_t access, files::Disk& disk);
/// Returns errno of the first failed write of an open file, or 0 if all succeeded.
int hdf5_output_error(std::int64_t file);
/// Stores hdf5_output_error() in `error`, which must outlive the file, once the file is closed:
/// closing writes too.
void report_hdf5_output_error(std::int64_t file, int& error);

}  // namespace morphe::store
