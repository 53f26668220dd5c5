#include "fuzz/targets/structure_reading.hpp"
#include "stridor/io/structure/abaqus.hpp"
#include "stridor/io/structure/calculix.hpp"
#include "stridor/io/structure/harwell_boeing.hpp"
#include "stridor/io/structure/matrix_market.hpp"
#include "stridor/io/structure/nastran/dmig.hpp"
#include "stridor/io/structure/nastran/output4.hpp"
#include "stridor/io/structure/nastran/output4_binary.hpp"
#include "stridor/io/structure/row_labels.hpp"

#include <string>
#include <vector>

// The readers of each finite-element program by themselves, so that each has all the runs: the target `structure` parts
// its own among them all. What tells a reader's files by their bytes stands before it here as there.

namespace stridor::fuzz {

namespace {

using io::structure::ListedMatrix;
using io::structure::MatrixRole;

std::string_view first_line(std::string_view bytes) {
    return bytes.substr(0, bytes.find_first_of("\r\n"));
}

// whatever is read has its entries within its rows
void look_at(const std::vector<ListedMatrix>& matrices) {
    for (const ListedMatrix& matrix : matrices) {
        for (const auto& entry : matrix.entries)
            require(entry.row() >= 0 && entry.row() < matrix.rows && entry.col() >= 0 && entry.col() < matrix.rows);
        require(matrix.labels.empty() || static_cast<Eigen::Index>(matrix.labels.size()) == matrix.rows);
        static_cast<void>(symmetric_matrix(matrix));
    }
}

}  // namespace

void calculix(std::string_view bytes) {
    expect_end([&] { look_at({io::structure::read_calculix_matrix(input_of(bytes), MatrixRole::mass)}); });
    expect_end([&] { io::structure::read_calculix_labels(input_of(bytes)); });
    const io::structure::IncludeOpener itself = [&](const std::string&, const std::string&) {
        return std::optional(input_of(bytes));
    };
    expect_end([&] { io::structure::read_calculix_deck(input_of(bytes), itself); });
}

void nastran(std::string_view bytes) {
    expect_end([&] {
        if (io::structure::is_output4_binary(bytes)) return look_at(read_output4_binary(input_of(bytes)));
        if (io::structure::is_output4(first_line(bytes))) return look_at(read_output4(input_of(bytes)));
        look_at(read_dmig(input_of(bytes)).matrices);
    });
}

void abaqus(std::string_view bytes) {
    expect_end([&] {
        if (io::structure::is_user_element(first_line(bytes))) return look_at(read_user_element(input_of(bytes)));
        look_at({read_abaqus_matrix(input_of(bytes))});
    });
    expect_end([&] { look_at({io::structure::read_coordinate_matrix(input_of(bytes))}); });
}

void ansys(std::string_view bytes) {
    expect_end([&] {
        if (io::structure::is_ansys_mapping(first_line(bytes))) {
            read_ansys_mapping(input_of(bytes));
            return;
        }
        look_at({read_harwell_boeing(input_of(bytes))});
    });
}

void matrix_market(std::string_view bytes) {
    expect_end([&] {
        if (io::structure::is_matrix_market(bytes)) return look_at({read_matrix_market(input_of(bytes))});
        read_row_table(input_of(bytes));
    });
}

}  // namespace stridor::fuzz
