#pragma once

#include <map>
#include <string>
#include <vector>

#include "stages/import/formats/c3d_bytes.hpp"

namespace morphe::imports {

/// The parameters of a C3D file by "GROUP:NAME", in capitals. A value is read when it is asked for.
class C3dParameters {
 public:
  /// Reads the section that begins at `start`, behind its four bytes of header. InputError for a
  /// record that leads outside the file, has no known type, or reaches into the next one.
  C3dParameters(const C3dBytes& bytes, std::size_t start);

  bool has(const std::string& key) const { return found_.contains(key); }
  /// All values of a parameter; empty if it is absent. InputError "FILE: KEY: …" if it is of
  /// another type. Integers of two bytes count from 0 to 65535; texts come without trailing spaces.
  std::vector<double> numbers(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;
  /// The first value, or what stands in if there is none.
  double number(const std::string& key, double otherwise) const;
  std::string text(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Record {
    int type = 0;  ///< -1 text, otherwise bytes of a number
    std::vector<std::size_t> dimensions;
    std::size_t offset = 0, count = 0;
  };
  Record read_record(std::size_t offset, std::size_t end, const std::string& name) const;

  const C3dBytes& bytes_;
  std::map<std::string, Record> found_;
};

}  // namespace morphe::imports
