#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::bindings {

namespace py = pybind11;

/// Numbers that Python gave: what numpy makes float64 of without loss of meaning, as rows of one shape. Holds the
/// array.
struct Rows {
  py::array_t<double, py::array::c_style> array;
  std::vector<py::ssize_t> lead;  // the shape before that of a row; empty: there is one
  std::size_t count = 1;          // of rows
  std::size_t size = 1;           // of a row
  /// The row at index.
  std::span<const double> row(std::size_t index) const { return {array.data() + index * size, size}; }
};

/// shape: of a row. A number for each, finite, of magnitude limit or less; TypeError or ValueError, with a sentence
/// that begins with name, for anything else.
Rows readRows(const py::handle& given, const char* name, std::initializer_list<py::ssize_t> shape, double limit);

/// An empty array of doubles of the shape lead + row.
py::array_t<double> emptyRows(const std::vector<py::ssize_t>& lead, std::initializer_list<py::ssize_t> row);

/// A list of other numbers.
template <class T>
py::array_t<T> emptyOf(const std::vector<py::ssize_t>& lead, std::initializer_list<py::ssize_t> row) {
  std::vector<py::ssize_t> shape = lead;
  shape.insert(shape.end(), row);
  return py::array_t<T>(shape);
}

/// Raises ValueError, of the problems' sentences with their places, or OSError where a file could not be read.
[[noreturn]] void raiseProblems(const Problems& problems);

/// Runs work(first, last) for all of count; without the interpreter's lock where it is worth it.
template <class Work>
void forAll(std::size_t count, const Work& work) {
  constexpr std::size_t kWorthUnlocking = 16;  // taking the lock again costs as much as a few poses
  if (count < kWorthUnlocking) return work(0, count);
  const py::gil_scoped_release unlocked;
  work(0, count);
}

}  // namespace underact::bindings
