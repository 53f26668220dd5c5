#include "stridor/io/case/own_structure/structure_matrices.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/reduced_netcdf.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace stridor::io {

namespace {

namespace csv = recordings::csv_table;
using reduction::ElasticPart;
using reduction::SparseMatrix;

bool is_csv(const std::string& path) {
    return csv::lower(std::filesystem::path(path).extension().string()) == ".csv";
}

// a number in each field, a row in each line
TomlRows read_csv_matrix(const structure::StructureInput& input) {
    recordings::LineReader lines(input.bytes, input.name);
    TomlRows rows;
    while (const auto line = lines.next()) {
        if (base::trimmed(line->text).empty() || line->text.starts_with('#')) continue;
        const csv::Dialect dialect = csv::sniff(line->text);
        std::vector<double> row;
        for (const csv::CsvField& field : csv::split(line->text, dialect.delimiter)) {
            const auto number = csv::number_in(field.text, dialect);
            if (!number)
                throw recordings::refusal(recordings::place_of(input.name, *line, field.column),
                                          fmt::format("\"{}\" is no number of a matrix", field.text));
            row.push_back(*number);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

SparseMatrix sparse(const TomlRows& rows, const TomlEntry& entry) {
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].size() != rows.size())
            throw Error(
                ErrorKind::input,
                {fmt::format("{} has {} rows, and {} numbers in row {}", entry.key, rows.size(), rows[i].size(), i + 1),
                 "a matrix of a structure is square", ""},
                entry.value_place);
        for (std::size_t j = 0; j < rows.size(); ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
    }
    return matrix.sparseView(0.0, 0.0);
}

SparseMatrix matrix_in(const TomlSection& section, std::string_view key) {
    const TomlEntry& entry = section.need(key);
    if (const auto* rows = std::get_if<TomlRows>(&entry.value)) return sparse(*rows, entry);
    const auto* name = std::get_if<std::string>(&entry.value);
    if (name == nullptr || !is_csv(*name))
        section.refuse_kind(entry, "a matrix, [[2, -1], [-1, 2]], or a file, \"k.csv\", as for the others");
    return sparse(read_csv_matrix(opened(section.path(entry, *name), entry)), entry);
}

// a table of numbers has no labels, and what reads parts does not read it
void expect_no_csv(const TomlSection& section) {
    for (const std::string_view key : {"mass", "stiffness", "damping"}) {
        const TomlEntry* entry = section.find(key);
        const auto* name = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
        if (name != nullptr && is_csv(*name))
            throw Error(ErrorKind::input,
                        {fmt::format("{} is CSV, and another matrix is not", entry->key), "",
                         "Give all of them as CSV or lists of rows, or none."},
                        entry->value_place);
    }
}

// is it a file that a reader of parts knows?
bool is_part_file(const TomlSection& section, std::string_view key) {
    const TomlEntry* entry = section.find(key);
    const auto* name = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
    return name != nullptr && !is_csv(*name);
}

NamedPart of_matrices(const TomlSection& section) {
    NamedPart named;
    named.origin = "matrices of the case";
    named.part.mass = matrix_in(section, "mass");
    named.part.stiffness = matrix_in(section, "stiffness");
    if (section.has("damping")) named.part.damping = matrix_in(section, "damping");
    const auto rows = static_cast<std::size_t>(rows_of(named.part));
    if (!section.has("rows")) {
        for (std::size_t k = 1; k <= rows; ++k)
            named.part.labels.push_back({"u" + std::to_string(k), 0});
        return named;
    }
    for (const std::string& name : section.texts("rows"))
        named.part.labels.push_back({name, 0});
    if (named.part.labels.size() != rows)
        throw Error(ErrorKind::input,
                    {fmt::format("structure.rows has {} names", named.part.labels.size()),
                     fmt::format("the stiffness has {} rows", rows), ""},
                    section.need("rows").value_place);
    return named;
}

NamedPart of_files(const TomlSection& section) {
    expect_no_csv(section);
    NamedPart named;
    PartFiles files;
    const auto path_of = [&](std::string_view key) {
        if (!section.has(key)) return std::string();
        const std::string name = section.text(key);
        named.origin += (named.origin.empty() ? "" : ", ") + name;
        return section.path(section.need(key), name);
    };
    if (section.has("file"))
        for (const std::string& name : section.texts("file")) {
            named.origin += (named.origin.empty() ? "" : ", ") + name;
            files.files.push_back(section.path(section.need("file"), name));
        }
    files.stiffness = path_of("stiffness");
    files.mass = path_of("mass");
    files.damping = path_of("damping");
    files.labels = path_of("labels");
    const bool is_one = files.files.size() == 1 && files.stiffness.empty();
    const auto beginning = [&] {
        return recordings::text_at(*opened(files.files.front(), section.need("file")).bytes, 0, 8);
    };
    if (is_one && is_netcdf(beginning())) {
        reduction::Reduction reduction = read_reduced_part(files.files.front());
        named.part = std::move(reduction.part);
        named.recovered = std::move(reduction.recovered);
        named.recovery = std::move(reduction.recovery);
        const bool is_macneal = reduction.method == reduction::ReductionMethod::macneal;
        if (is_macneal && !reduction.mode_frequencies.empty()) named.left_out_above = reduction.mode_frequencies.back();
        return named;
    }
    const std::string units = section.text_or("units", "m-kg-s");
    named.part = in_si(read_part(files), reduction::unit_system(units));
    return named;
}

}  // namespace

structure::StructureInput opened(const std::string& path, const TomlEntry& entry) {
    try {
        return {recordings::open_plain_bytes(path), path};
    } catch (const Error& error) {
        throw located(error, entry.key, entry.value_place);
    }
}

NamedPart part_in(const TomlSection& section) {
    const bool has_matrices = section.has("mass") || section.has("stiffness");
    if (!section.has("file") && !has_matrices)
        throw Error(ErrorKind::input,
                    {"nothing says what the structure is", "",
                     "Give mass and stiffness, a file of a part, or a builder (\"chain\", \"string\", \"beam\")."},
                    section.place());
    const bool is_of_files = section.has("file") || is_part_file(section, "mass") || is_part_file(section, "stiffness");
    try {
        NamedPart named = is_of_files ? of_files(section) : of_matrices(section);
        expect_sound(named.part);
        return named;
    } catch (const Error& error) {
        if (error.place()) throw;
        const TomlEntry* file = section.find("file");
        throw Error(error.kind(), error.problem(), file != nullptr ? file->value_place : section.place());
    }
}

}  // namespace stridor::io
