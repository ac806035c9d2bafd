#pragma once

#include <filesystem>
#include <string>

#include "pipeline/study/study.hpp"

namespace morphe::study {

/// Returns {study, rows: [{case: {…}, metric, unit, ours, published, reachable, count}]} as JSON. A
/// row with a requirement also has `requirement` (such as ">= 0.99") and `requirement_met`. NaN is
/// written as null, and timed rows are left out.
std::string results_json(const StudyResult& result);
/// Returns the same data as CSV with a header line; the values of a case are joined by "; ".
std::string results_csv(const StudyResult& result);
/// Returns a table for display, including timed rows.
std::string results_table(const StudyResult& result);

/// Writes results.json, .csv, .h5 ("morphe-study", one dataset per column), one .svg per plot or
/// grid of plots, and one .md per table.
void write_results(const StudyResult& result, const std::filesystem::path& folder);

}  // namespace morphe::study
