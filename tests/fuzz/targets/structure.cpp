#include "fuzz/targets/structure_reading.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/structure/calculix.hpp"
#include "stridor/io/structure/part_files.hpp"

#include <string>

namespace stridor::fuzz {

namespace {

using io::structure::StructureInput;

// a part is one of finite numbers, or says why it is none
void read_as(std::string_view bytes, const io::PartFiles& files) {
    const io::FileOpener open = [&](const std::string& path) -> std::optional<StructureInput> {
        return StructureInput{recordings::bytes_of(std::string(bytes)), path};
    };
    expect_end([&] {
        const reduction::ElasticPart part = io::read_part(files, open);
        require(part.mass.rows() == part.stiffness.rows());
        require(static_cast<Eigen::Index>(part.labels.size()) == part.stiffness.rows());
        constexpr Eigen::Index few_rows = 200;
        if (rows_of(part) > few_rows) return;
        try {
            expect_sound(part);
        } catch (const Error& error) {
            require(error.kind() == ErrorKind::input);
        }
    });
}

}  // namespace

void structure(std::string_view bytes) {
    read_as(bytes, {.files = {"input"}});
    read_as(bytes, {.stiffness = "k", .mass = "m"});
    read_as(bytes, {.files = {"j.sti"}});  // the same bytes as matrices, labels and deck
    expect_end([&] { io::structure::read_calculix_matrix(input_of(bytes), io::structure::MatrixRole::mass); });
    expect_end([&] { io::structure::read_calculix_labels(input_of(bytes)); });
    const io::structure::IncludeOpener itself = [&](const std::string&, const std::string&) {
        return std::optional(input_of(bytes));
    };
    expect_end([&] { io::structure::read_calculix_deck(input_of(bytes), itself); });
}

}  // namespace stridor::fuzz
