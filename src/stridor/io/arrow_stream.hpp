#pragma once

#include "stridor/io/arrow_abi.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

/// Tables for other programs in this process, by Arrow's C stream interface
/// (https://arrow.apache.org/docs/format/CStreamInterface.html): pyarrow, polars, DuckDB and pandas take them without a
/// library in between.
namespace stridor::io {

/// What the values of a column are.
enum class ArrowKind {
    number,   // float64
    integer,  // int64
    word,     // a dictionary of UTF-8 strings with int32 indices
};

/// One column.
struct ArrowColumn {
    std::string name;
    std::map<std::string, std::string> about;  // the field's metadata: "unit", "long_name"
    ArrowKind kind = ArrowKind::number;
    std::vector<double> values;      // by kind, of words their numbers; NaN is a missing value, a null; shape [row]
    std::vector<std::string> words;  // of words alone
};

/// Columns of one length.
struct ArrowTable {
    std::vector<ArrowColumn> columns;
    std::map<std::string, std::string> about{};  // the schema's metadata
    std::size_t rows_at_once = 65536;            // [1] rows of a chunk, a multiple of 64
};

/// A stream of chunks of a table, each a struct array with a child per column. The caller owns it, and ends it by its
/// release(). Schemas and chunks live on without the stream, and children without their parents. Nothing of it belongs
/// to a thread or an interpreter.
///
/// Throws `Error` (input) for columns of different lengths, and numbers of words that are none.
ArrowArrayStream arrow_stream(ArrowTable table);

}  // namespace stridor::io
