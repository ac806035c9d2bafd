#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/parquet/column.hpp"

namespace morphe::parquet {

/// The place of one column of a row group in the file.
struct ChunkPlace {
  std::int64_t offset = 0;       ///< of its page header, from the begin of the file
  std::int64_t size = 0;         ///< bytes of its page with the header
  std::int64_t value_count = 0;  ///< nulls and empty lists included
};

/// A row group, with a place for each column.
struct RowGroup {
  std::int64_t rows = 0;
  std::vector<ChunkPlace> chunks;
};

/// Returns the header of a data page of version 1 with plain values (Thrift).
std::string page_header(std::int64_t value_count, std::int64_t body_bytes);

/// Returns the metadata of a file (Thrift), which come before its last eight bytes.
std::string file_metadata(const std::vector<Column>& columns, const std::vector<RowGroup>& groups,
                          const std::vector<KeyValue>& entries, const std::string& created_by);

}  // namespace morphe::parquet
