#pragma once
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/record/table.h"

namespace underact::record {

/// A column, and where a row has its numbers. The fields of all tables are the one description of what a session holds:
/// its file, CSV, live data, the service, plots, Python and the guide's page follow them.
template <class Access>
struct Field {
  /// its_scale: see scale.
  constexpr Field(const Column& its_column, Access its_access, double its_scale = 1.0)
      : column(its_column), access(its_access), scale(its_scale) {}
  Column column;
  Access access;  // of a row, a number or several to be read and set; or what is computed from a row and something else
  double scale;   // how many of the column's units one of the row's is
};

/// The fields of a table whose rows are of that type: a specialisation for each.
template <class Row>
inline constexpr std::tuple<> kFields{};

/// The columns of these fields.
template <class Row>
inline constexpr std::array kColumns = std::apply([](const auto&... field) { return std::array{field.column...}; },
                                                  kFields<Row>);

/// The first and the last of an enumeration that a column has; any other value is read as the first.
template <class Enumeration>
inline constexpr std::pair<Enumeration, Enumeration> kEnumerators{};

/// A member of a member.
template <class Outer, class Inner>
constexpr auto within(Outer outer, Inner inner) {
  return [ outer, inner ](auto& row) -> auto& {
    return row.*outer.*inner;
  };
}

/// Calls visit() with each number of a field in a row.
template <class Access, class Row, class Visit, class... Besides>
void eachNumber(const Field<Access>& field, Row& row, const Visit& visit, const Besides&... besides) {
  const auto each = [&visit](auto&& value) {
    if constexpr (requires { value.begin(); }) {
      for (auto&& number : value) visit(number);
    } else if constexpr (requires { std::tuple_size<std::remove_cvref_t<decltype(value)>>::value; }) {
      std::apply([&visit](auto&... numbers) { (visit(numbers), ...); }, value);
    } else {
      visit(value);
    }
  };
  if constexpr (std::is_invocable_v<const Access&, Row&>) {
    each(std::invoke(field.access, row));
  } else {
    each(std::invoke(field.access, row, besides...));
  }
}

/// A number in the column's unit.
template <class Access, class Number>
constexpr double scaled(const Field<Access>& field, Number number) {
  const auto value = static_cast<double>(number);
  return field.scale == 1.0 ? value : field.scale * value;  // to the bit where there is nothing to scale
}

/// Packs a row.
template <class Row, class... Besides>
void packFields(const auto& fields, const Row& row, Packer& packer, const Besides&... besides) {
  const auto pack_field = [&](const auto& field) {
    const auto put = [&](auto number) {
      switch (field.column.kind) {
        case NumberKind::Byte:
          return packer.byte(static_cast<std::uint8_t>(number));
        case NumberKind::Unsigned:
          return packer.unsigned32(static_cast<std::uint32_t>(number));
        case NumberKind::Integer:
          return packer.integer(static_cast<std::int64_t>(number));
        case NumberKind::Real:
          return packer.real(scaled(field, number));
      }
    };
    eachNumber(field, row, put, besides...);
  };
  std::apply([&](const auto&... field) { (pack_field(field), ...); }, fields);
}

/// A number of a file as a row has it.
template <class Number, class Value>
Number fromFile(Value value) {
  if constexpr (std::is_enum_v<Number>) {
    const auto [first, last] = kEnumerators<Number>;
    const auto wanted = static_cast<Number>(value);
    return first <= wanted && wanted <= last ? wanted : first;
  } else if constexpr (std::is_integral_v<Number> && std::is_floating_point_v<Value>) {
    return static_cast<Number>(std::llround(value));
  } else {
    return static_cast<Number>(value);
  }
}

/// Reads the fields of the next row; what is computed from it is left out.
template <class Row>
void unpackFields(const auto& fields, Unpacker& unpacker, Row& row) {
  const auto unpack_field = [&]<class Access>(const Field<Access>& field) {
    const auto take = [&]<class Number>(Number& number) {
      switch (field.column.kind) {
        case NumberKind::Byte:
          return void(number = fromFile<Number>(unpacker.byte()));
        case NumberKind::Unsigned:
          return void(number = fromFile<Number>(unpacker.unsigned32()));
        case NumberKind::Integer:
          return void(number = fromFile<Number>(unpacker.integer()));
        case NumberKind::Real:
          const double value = unpacker.real();
          return void(number = fromFile<Number>(field.scale == 1.0 ? value : value / field.scale));
      }
    };
    if constexpr (std::is_invocable_v<const Access&, Row&>) {
      eachNumber(field, row, take);
    } else {
      for (int part = 0; part < field.column.width; ++part) unpacker.real();
    }
  };
  std::apply([&](const auto&... field) { (unpack_field(field), ...); }, fields);
}

/// For a Packer of kColumns<Row>.
template <class Row>
void pack(const Row& row, Packer& packer) {
  packFields(kFields<Row>, row, packer);
}

/// One row, packed as a block of its table.
template <class Row>
Block blockOf(const Row& row) {
  Packer packer(kColumns<Row>);
  packer.begin(1);
  pack(row, packer);
  return packer.block();
}

/// The rows of a whole block; a value outside an enumeration is read as its first one.
template <class Row>
std::vector<Row> unpack(const Block& block) {
  std::vector<Row> rows;
  for (Unpacker unpacker(kColumns<Row>, block); !unpacker.isDone();)
    unpackFields(kFields<Row>, unpacker, rows.emplace_back());
  return rows;
}

}  // namespace underact::record
