#pragma once

namespace morphe::run {

/// Makes what would abort the process, or end it with another code, end it with exit code 2 and a
/// message, after unfinished paths (files::UnfinishedPath) were removed: an exception that nothing
/// can catch, thrown by a destructor or by a thread of a library (TBB throws where it cannot start
/// one), and a library that calls exit(), as HDF5 does if it cannot allocate a node of the list of
/// its identifiers (H5I_register). `main` calls it once, at first.
void report_abnormal_ends();

/// Says that `main` has a result: exit() is no abnormal end any more.
void expect_end();

}  // namespace morphe::run
