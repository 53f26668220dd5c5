#include "stridor/io/structure/part_files.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/abaqus.hpp"
#include "stridor/io/structure/calculix.hpp"
#include "stridor/io/structure/chosen_matrices.hpp"
#include "stridor/io/structure/harwell_boeing.hpp"
#include "stridor/io/structure/matrix_market.hpp"
#include "stridor/io/structure/nastran/dmig.hpp"
#include "stridor/io/structure/nastran/output4.hpp"
#include "stridor/io/structure/nastran/output4_binary.hpp"
#include "stridor/io/structure/numpy_array.hpp"
#include "stridor/io/structure/numpy_matrix.hpp"
#include "stridor/io/structure/row_labels.hpp"
#include "stridor/io/structure/zip_archive.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace stridor::io {

namespace {

using recordings::refusal;
using reduction::ElasticPart;
using namespace structure;

/// The beginning of a file, by lines.
struct Beginning {
    std::string text;
    std::vector<std::string_view> lines;  // at most so many as matter
    std::string_view first_data;          // the first that is neither empty nor a comment of Abaqus or CSV
};

constexpr std::size_t looked_at = 8192;  // [bytes] of a file to tell its kind

void find_lines(Beginning& beginning) {
    const std::string_view text = beginning.text;
    for (std::size_t from = 0; from < text.size() && beginning.lines.size() < 100;) {
        const std::size_t end = std::min(text.find_first_of("\r\n", from), text.size());
        const std::string_view line = text.substr(from, end - from);
        beginning.lines.push_back(line);
        const std::string_view bare = base::trimmed(line);
        if (beginning.first_data.empty() && !bare.empty() && !bare.starts_with("**") && !bare.starts_with('#'))
            beginning.first_data = line;
        from = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    }
}

bool is_numbers(std::string_view line) {
    return line.find_first_not_of("0123456789+-.eEdD \t") == std::string_view::npos;
}

/// Gathers what the files hold, and makes a part of it.
class PartReader {
public:
    explicit PartReader(const FileOpener& open) : open_(open) {}

    StructureInput input(const std::string& path) const {
        auto found = open_(path);
        if (!found) throw Error(ErrorKind::io, {fmt::format("cannot open \"{}\"", path), "it is not there", ""});
        return std::move(*found);
    }

    void take(const std::string& path, MatrixRole role) {
        const std::size_t mark = path.rfind(':');  // FILE:NAME, one of several matrices of a file
        if (role != MatrixRole::untold && mark != std::string::npos && !open_(path))
            return take_named(path.substr(0, mark), path.substr(mark + 1), role);
        const StructureInput found = input(path);
        Beginning beginning{recordings::text_at(*found.bytes, 0, looked_at), {}, {}};
        find_lines(beginning);
        const std::size_t before = matrices_.size();
        if (!take_matrices(found, beginning, role))
            throw refusal(path, "it is no file of a part that is known",
                          "known are CalculiX (.sti, .mas, .dof), Matrix Market, Abaqus matrices, Nastran's DMIG and "
                          "OUTPUT4, Ansys' Harwell-Boeing, NumPy's .npz, and tables of labels");
        const bool is_one = matrices_.size() == before + 1;
        if (!is_one || role == MatrixRole::untold) return;
        matrices_.back().role = role;
        matrices_.back().is_named_by_user = true;
    }

    void take_labels(const std::string& path) {
        const StructureInput found = input(path);
        Beginning beginning{recordings::text_at(*found.bytes, 0, looked_at), {}, {}};
        find_lines(beginning);
        if (!take_table(found, beginning))
            throw refusal(path, "it holds no labels",
                          "it is a table with the columns node and component, or a mapping");
    }

    ElasticPart finish() {
        const PartMatrices chosen = chosen_matrices(matrices_);
        const bool is_labelled = !chosen.stiffness->labels.empty();
        ElasticPart part = joined_part(*chosen.stiffness, *chosen.mass, chosen.damping);
        if (!is_labelled) put_labels(part);
        part.positions = std::move(positions_);
        part.sets = std::move(sets_);
        part.notes.insert(part.notes.end(), chosen.notes.begin(), chosen.notes.end());
        return part;
    }

private:
    void take_named(const std::string& path, const std::string& name, MatrixRole role) {
        PartReader of_file(open_);
        of_file.take(path, MatrixRole::untold);
        positions_.merge(of_file.positions_);
        std::string names;
        for (ListedMatrix& matrix : of_file.matrices_) {
            names += (names.empty() ? "" : ", ") + matrix.name;
            if (matrix.name != name || matrix.is_passed_over) continue;
            matrix.role = role;
            matrix.is_named_by_user = true;
            return matrices_.push_back(std::move(matrix));
        }
        throw refusal(path, fmt::format("there is no square matrix {} in it", name), "it holds " + names);
    }

    bool take_matrices(const StructureInput& found, const Beginning& beginning, MatrixRole role) {
        if (is_zip(beginning.text)) return take_npz(found, role);
        if (is_output4_binary(beginning.text)) return add(read_output4_binary(found));
        if (is_numpy_array(beginning.text)) return add(read_npy(found), role);
        if (is_matrix_market(beginning.text)) return add(read_matrix_market(found), role);
        if (beginning.lines.size() > 2 && is_harwell_boeing(beginning.lines[2]))
            return add(read_harwell_boeing(found), role);
        if (take_table(found, beginning)) return true;
        if (is_dmig(beginning.text)) return take_dmig(found);
        if (!beginning.lines.empty() && is_output4(beginning.lines[0])) return add(read_output4(found));
        if (is_user_element(beginning.first_data)) return add(read_user_element(found));
        const bool is_keyword = beginning.first_data.starts_with('*');
        if (is_abaqus_matrix(beginning.first_data) || is_keyword) return add(read_abaqus_matrix(found), role);
        if (!beginning.first_data.empty() && is_numbers(beginning.first_data))
            return add(read_coordinate_matrix(found), role);
        return false;
    }

    bool take_table(const StructureInput& found, const Beginning& beginning) {
        if (!beginning.lines.empty() && is_ansys_mapping(beginning.lines[0])) {
            put_labels_once(found.name, read_ansys_mapping(found));
            return true;
        }
        if (!is_row_table(beginning.first_data)) return false;
        RowTable table = read_row_table(found);
        put_labels_once(found.name, std::move(table.labels));
        positions_.merge(table.positions);
        sets_ = std::move(table.sets);
        return true;
    }

    // one sparse matrix, which does not say what it is, or dense ones with names
    bool take_npz(const StructureInput& found, MatrixRole role) {
        std::vector<ListedMatrix> matrices = read_npz(found);
        if (matrices.front().role == MatrixRole::other) matrices.front().role = MatrixRole::untold;
        if (matrices.size() == 1) return add(std::move(matrices.front()), role);
        return add(std::move(matrices));
    }

    bool take_dmig(const StructureInput& found) {
        DmigFile file = read_dmig(found);
        positions_.merge(file.positions);
        return add(std::move(file.matrices));
    }

    // they have names that tell what they are
    bool add(std::vector<ListedMatrix> matrices) {
        for (ListedMatrix& matrix : matrices)
            matrices_.push_back(std::move(matrix));
        return true;
    }

    // Abaqus names its files: job_STIF2.mtx, job_MASS2.mtx
    bool add(ListedMatrix matrix, MatrixRole role) {
        const std::string name = upper(std::filesystem::path(matrix.file).filename().string());
        if (role == MatrixRole::untold && matrix.role == MatrixRole::untold) {
            constexpr std::array<std::pair<std::string_view, MatrixRole>, 3> marks{
                {{"STIF", MatrixRole::stiffness}, {"MASS", MatrixRole::mass}, {"DAMP", MatrixRole::damping}}};
            for (const auto& [mark, its] : marks)
                if (name.find(mark) != std::string::npos) matrix.role = its;
            if (matrix.role == MatrixRole::untold)
                throw refusal(matrix.file, "it does not say whether it is stiffness or mass", "",
                              "Name it with --stiffness FILE or --mass FILE.");
        }
        matrices_.push_back(std::move(matrix));
        return true;
    }

    void put_labels_once(const std::string& file, std::vector<reduction::RowLabel> labels) {
        if (!labels_.empty()) throw refusal(file, "it labels rows that are labelled already", "one table is enough");
        if (labels.empty()) throw refusal(file, "there is no label in it");
        labels_ = std::move(labels);
        label_file_ = file;
    }

    void put_labels(ElasticPart& part) const {
        if (labels_.empty()) {
            for (Eigen::Index row = 0; row < rows_of(part); ++row)
                part.labels.push_back({std::to_string(row + 1), 0});
            part.notes.emplace_back("without labels the rows are numbered from 1, and have neither node nor direction");
            return;
        }
        if (static_cast<Eigen::Index>(labels_.size()) != rows_of(part))
            throw refusal(label_file_,
                          fmt::format("it labels {} rows, the stiffness has {}", labels_.size(), rows_of(part)),
                          "there is a label for each row of the matrices, in their order");
        part.labels = labels_;
    }

    const FileOpener& open_;
    std::vector<ListedMatrix> matrices_;
    std::vector<reduction::RowLabel> labels_;
    std::string label_file_;
    std::map<std::string, Eigen::Vector3d> positions_;
    std::vector<reduction::NodeSet> sets_;
};

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool is_calculix(const std::string& path) {
    const std::string ending = ending_of(path);
    return ending == ".sti" || ending == ".mas" || ending == ".dof" || ending == ".inp";
}

// the other files of the job stand beside the one that was named, unless they were named, too
ElasticPart read_calculix_job(const PartFiles& files, const FileOpener& open) {
    const auto path_of = [&](const std::string& ending) {
        for (const std::string& path : files.files)
            if (ending_of(path) == ending) return path;
        return std::filesystem::path(files.files.front()).replace_extension(ending).string();
    };
    const PartReader reader(open);
    auto stiffness = open(path_of(".sti"));
    if (!stiffness)
        throw refusal(files.files.front(), fmt::format("there is no {} beside it", path_of(".sti")),
                      "CalculiX stores the matrices there if it is told to",
                      "Let the deck's step be *FREQUENCY, SOLVER=MATRIXSTORAGE and run CalculiX.");
    CalculixFiles job{.stiffness = *std::move(stiffness),
                      .mass = reader.input(path_of(".mas")),
                      .labels = reader.input(path_of(".dof")),
                      .deck = open(path_of(".inp"))};
    job.open_include = [&open](const std::string& name, const std::string& from) {
        return open((std::filesystem::path(from).parent_path() / name).string());
    };
    return read_calculix(job);
}

}  // namespace

std::string origin(const PartFiles& files) {
    std::string names = fmt::format("{}", fmt::join(files.files, ", "));
    for (const std::string& file : {files.stiffness, files.mass, files.damping, files.labels})
        if (!file.empty()) names += (names.empty() ? "" : ", ") + file;
    return names;
}

ElasticPart read_part(const PartFiles& files, const FileOpener& open) {
    if (!files.files.empty() && std::all_of(files.files.begin(), files.files.end(), is_calculix))
        return read_calculix_job(files, open);
    PartReader reader(open);
    for (const std::string& path : files.files)
        reader.take(path, MatrixRole::untold);
    if (!files.stiffness.empty()) reader.take(files.stiffness, MatrixRole::stiffness);
    if (!files.mass.empty()) reader.take(files.mass, MatrixRole::mass);
    if (!files.damping.empty()) reader.take(files.damping, MatrixRole::damping);
    if (!files.labels.empty()) reader.take_labels(files.labels);
    return reader.finish();
}

ElasticPart read_part(const PartFiles& files) {
    return read_part(files, [](const std::string& path) -> std::optional<StructureInput> {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) return std::nullopt;
        return StructureInput{recordings::open_plain_bytes(path), path};
    });
}

}  // namespace stridor::io
