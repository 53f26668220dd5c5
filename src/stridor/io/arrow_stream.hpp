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

/// The kind of a column's values.
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
    std::vector<double> values;      // by kind, words as numbers; NaN is a missing value, a null; shape [row]
    std::vector<std::string> words;  // for columns of words alone
};

/// Columns of one length.
struct ArrowTable {
    std::vector<ArrowColumn> columns;
    std::map<std::string, std::string> about{};  // the schema's metadata
    std::size_t rows_at_once = 65536;            // [1] rows of a chunk, a multiple of 64
};

/// Returns a stream of chunks of a table, each a struct array with a child per column. The caller owns it, and ends it
/// by its release(). Schemas and chunks outlive the stream, and children outlive their parents. No part of it belongs
/// to a thread or an interpreter.
///
/// Throws `Error` (input) for columns of different lengths, and for invalid numbers of words.
ArrowArrayStream arrow_stream(ArrowTable table);

}  // namespace stridor::io
