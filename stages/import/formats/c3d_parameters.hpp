#pragma once

#include <map>
#include <string>
#include <vector>

#include "stages/import/formats/c3d_bytes.hpp"

namespace morphe::imports {

/// The parameters of a C3D file by "GROUP:NAME", in capitals. A value is read on request.
class C3dParameters {
 public:
  /// Reads the section that begins at `start`, after its four bytes of header, and ends before
  /// `section_end`: the last record of some files points beyond. Throws InputError for a record
  /// that exceeds the file, has an unknown type, or overlaps the next one.
  C3dParameters(const C3dBytes& bytes, std::size_t start, std::size_t section_end);

  /// Returns true if the parameter exists.
  bool has(const std::string& key) const { return records_.contains(key); }
  /// Returns all values of a parameter; empty if absent. Throws InputError "FILE: KEY: …" for
  /// another type. Integers of two bytes are 0 to 65535; texts have no trailing spaces.
  std::vector<double> numbers(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;
  /// Returns the first value; `fallback`, or "", if it is absent.
  double number(const std::string& key, double fallback) const;
  std::string text(const std::string& key) const;
  /// Throws InputError "FILE: KEY: …".
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Record {
    int type = 0;  ///< -1 for text, otherwise the number of bytes of a value
    std::vector<std::size_t> dimensions;
    std::size_t offset = 0, count = 0;
  };
  Record read_record(std::size_t offset, std::size_t end, const std::string& name) const;

  const C3dBytes& bytes_;
  std::map<std::string, Record> records_;
};

}  // namespace morphe::imports
