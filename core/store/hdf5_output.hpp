#pragma once

#include <cstdint>

#include "core/files/disk.hpp"

namespace morphe::store {

/// Sets up a file to be written to `disk` by an output driver; `access` is its list of access
/// properties. The HDF5 library crashes after a failed write, when it closes data that it could not
/// flush. This driver is otherwise equal to the default one (same calls, same bytes), but never
/// reports a failure to HDF5: it stores the error for hdf5_output_error().
void write_through_output_driver(std::int64_t access, files::Disk& disk);
/// Returns errno of the first failed write of an open file, or 0 if all succeeded.
int hdf5_output_error(std::int64_t file);
/// Stores this errno in `error` when the file is closed, because closing writes too.
void report_hdf5_output_error(std::int64_t file, int& error);

}  // namespace morphe::store
