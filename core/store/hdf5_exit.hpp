#pragma once

namespace morphe::store {

/// Keeps the HDF5 library from closing what is open when the process ends, during which it crashes
/// after an allocation that failed. It is for a program that closes its files, and must be called
/// before everything else of this folder.
void close_nothing_at_exit();

}  // namespace morphe::store
