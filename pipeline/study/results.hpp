#pragma once

#include <filesystem>
#include <string>

#include "pipeline/study/study.hpp"

namespace morphe::study {

/// {study, rows: [{case: {…}, metric, unit, ours, published, reachable, n, wanted, holds}]}; NaN is
/// null, `wanted` (such as ">= 0.99") and `holds` stand where something is asked for.
std::string results_json(const StudyResult& result);
/// The same as a table with a header line: the case's values joined by "; ".
std::string results_csv(const StudyResult& result);
/// For a person, timed rows included.
std::string results_table(const StudyResult& result);

/// results.json, .csv, .h5 (format "morphe-study": a dataset a column) and one .svg a plot.
void write_results(const StudyResult& result, const std::filesystem::path& folder);

}  // namespace morphe::study
