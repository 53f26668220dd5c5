#include "stridor/io/structure/reduced_netcdf.hpp"

#include "stridor/base/child_process.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/io/structure/row_labels.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace stridor::io {

namespace {

using reduction::BoundaryInertia;
using reduction::ElasticPart;
using reduction::Reduction;
using reduction::ReductionMethod;
using reduction::RowLabel;

constexpr std::array<std::string_view, 7> component_names{"none",       "x",          "y",         "z",
                                                          "rotation_x", "rotation_y", "rotation_z"};
constexpr std::string_view schema = "stridor.structure/1";

// what is read of a file, by name, in the order of the checksum
constexpr std::array numeric{"stiffness",      "mass",     "damping",  "row_component",
                             "mode_frequency", "position", "recovery", "recovered_component"};
constexpr std::array worded{"row_node", "node", "node_sets", "recovered_node"};
constexpr std::array said{"schema", "contact_inertia", "method"};
constexpr const char* checksum_name = "content_sha256";

/// What a file holds; what it lacks is empty.
struct PartContent {
    std::map<std::string, std::string> texts;
    std::map<std::string, std::vector<double>> numbers;
    std::map<std::string, std::vector<std::string>> words;
};

// lowest byte first, on any machine
void add_whole(base::Sha256& digest, std::uint64_t value) {
    std::array<char, 8> bytes;
    for (std::size_t k = 0; k < bytes.size(); ++k)
        bytes[k] = static_cast<char>(value >> (8 * k) & 0xFFU);
    digest.add({bytes.data(), bytes.size()});
}

void add_text(base::Sha256& digest, std::string_view text) {
    add_whole(digest, text.size());
    digest.add(text);
}

// of all that is read of a file: a bit that a disk or a copy turned gives another part, and no error of HDF5's
std::string checksum_of(PartContent& content) {
    base::Sha256 digest;
    for (const char* name : said)
        add_text(digest, content.texts[name]);
    for (const char* name : numeric) {
        add_whole(digest, content.numbers[name].size());
        for (const double number : content.numbers[name])
            add_whole(digest, std::bit_cast<std::uint64_t>(number));
    }
    for (const char* name : worded) {
        add_whole(digest, content.words[name].size());
        for (const std::string& word : content.words[name])
            add_text(digest, word);
    }
    return digest.text();
}

/// Puts what a part holds into its file, and remembers it for the checksum.
class PartWriter {
public:
    explicit PartWriter(NetcdfDataset& file) : file_(file) {}

    void text(const std::string& name, const std::string& text) {
        file_.attribute(name, text);
        content_.texts[name] = text;
    }
    void numbers(const std::string& name, std::span<const int> along, std::vector<double> values,
                 const Description& description) {
        file_.doubles(name, along, values, description);
        content_.numbers[name] = std::move(values);
    }
    void words(const std::string& name, int along, std::vector<std::string> values, const Description& description) {
        file_.words(name, std::array{along}, values, description);
        content_.words[name] = std::move(values);
    }
    void labels(const std::string& prefix, int along, const std::vector<RowLabel>& labels) {
        std::vector<std::string> nodes;
        std::vector<signed char> components;
        for (const RowLabel& label : labels) {
            nodes.push_back(label.node);
            components.push_back(static_cast<signed char>(label.component));
        }
        words(prefix + "_node", along, std::move(nodes), {"", "node, or the mode's name"});
        file_.flags(prefix + "_component", std::array{along}, components, {component_names},
                    {"", "direction of motion"});
        content_.numbers[prefix + "_component"].assign(components.begin(), components.end());
    }
    /// The last that is put.
    void checksum(const std::string& schema_text) {
        content_.texts["schema"] = schema_text;
        file_.attribute(checksum_name, checksum_of(content_));
    }

private:
    NetcdfDataset& file_;
    PartContent content_;
};

std::vector<double> row_major(const Eigen::MatrixXd& matrix) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(matrix.size()));
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        for (Eigen::Index column = 0; column < matrix.cols(); ++column)
            values.push_back(matrix(row, column));
    return values;
}

// places, and the sets that each node is in
void put_nodes(NetcdfDataset& file, PartWriter& writer, const ElasticPart& part) {
    if (part.positions.empty()) return;
    std::vector<std::string> names;
    std::vector<std::string> sets;
    std::vector<double> places;
    std::map<std::string, std::vector<std::string_view>> sets_of;  // a node may stand in a set twice
    for (const reduction::NodeSet& set : part.sets)
        for (const std::string& node : set.nodes)
            if (auto& its = sets_of[node]; its.empty() || its.back() != set.name) its.emplace_back(set.name);
    for (const auto& [node, position] : part.positions) {
        names.push_back(node);
        places.insert(places.end(), position.begin(), position.end());
        sets.push_back(fmt::format("{}", fmt::join(sets_of[node], " ")));
    }
    const int node = file.dimension("node", names.size());
    const int axis = file.dimension("axis", 3);
    writer.words("node", node, std::move(names), {"", "node"});
    writer.words("node_sets", node, std::move(sets), {"", "sets that the node is in, with blanks between"});
    writer.numbers("position", std::array{node, axis}, std::move(places),
                   {"m", "place of the node", MissingNumbers::no});
}

}  // namespace

void write_reduced_part(const std::string& path, const Reduction& reduction, const std::string& origin) {
    const ElasticPart& part = reduction.part;
    NetcdfDataset file(path);
    put(file, origin_attributes("structure", "reduced finite-element part"));
    PartWriter writer(file);
    file.attribute("origin", origin);
    writer.text("method", std::string(name_of(reduction.method)));
    if (reduction.solver != reduction::LinearSolver::eigen)
        file.attribute("solver", std::string(name_of(reduction.solver)));
    writer.text("contact_inertia", std::string(name_of(reduction.inertia)));
    const int row = file.dimension("row", part.labels.size());
    const int column = file.dimension("column", part.labels.size());
    writer.labels("row", row, part.labels);
    const auto put = [&](const std::string& name, const Eigen::MatrixXd& matrix, const Description& description) {
        writer.numbers(name, std::array{row, column}, row_major(matrix), description);
    };
    put("stiffness", Eigen::MatrixXd(part.stiffness), {"N/m", "stiffness", MissingNumbers::no});
    put("mass", Eigen::MatrixXd(part.mass), {"kg", "mass", MissingNumbers::no});
    if (part.damping.rows() != 0)
        put("damping", Eigen::MatrixXd(part.damping), {"N*s/m", "damping", MissingNumbers::no});
    if (!reduction.mode_frequencies.empty()) {
        const int mode = file.dimension("mode", reduction.mode_frequencies.size());
        writer.numbers("mode_frequency", std::array{mode}, reduction.mode_frequencies,
                       {"Hz", "frequency of the mode", MissingNumbers::no});
    }
    put_nodes(file, writer, part);
    if (!reduction.recovered.empty()) {
        const int recovered = file.dimension("recovered", reduction.recovered.size());
        writer.labels("recovered", recovered, reduction.recovered);
        writer.numbers("recovery", std::array{recovered, column}, row_major(reduction.recovery),
                       {"1", "displacement of other rows = recovery * coordinates", MissingNumbers::no});
    }
    writer.checksum(std::string(schema));
    file.finish([&](std::string_view bytes) { storage::write_file(path, bytes); });
}

bool is_netcdf(std::string_view beginning) {
    return beginning.starts_with("\x89HDF\r\n\x1a\n") || beginning.starts_with("CDF");
}

bool is_reduced_part(const PartFiles& files) {
    return files.files.size() == 1 &&
           is_netcdf(recordings::text_at(*recordings::open_plain_bytes(files.files.front()), 0, 8));
}

namespace {

constexpr std::size_t most_numbers = std::size_t{1} << 26U;  // of a variable: 8000 rows
constexpr std::size_t most_words = std::size_t{1} << 20U;
constexpr std::uint64_t longest_answer = std::uint64_t{4} << 30U;
constexpr std::uint64_t largest_file = std::uint64_t{2} << 30U;

/// The confined side: asks the library and packs what it says. A variable that is not there has no sizes.
class OpenedPart {
public:
    explicit OpenedPart(int file) : file_(file) {}

    void text(const char* name, base::Packing& into) const {
        std::size_t length = 0;
        nc_type type = NC_NAT;
        const bool is_there = nc_inq_atttype(file_, NC_GLOBAL, name, &type) == NC_NOERR && type == NC_CHAR &&
                              nc_inq_attlen(file_, NC_GLOBAL, name, &length) == NC_NOERR && length < 65536;
        std::string value(is_there ? length : 0, '\0');
        if (is_there) nc_get_att_text(file_, NC_GLOBAL, name, value.data());
        into.add(std::string_view(value));
    }

    void numbers(const char* name, base::Packing& into) const {
        const auto found = variable(name, NC_DOUBLE, NC_BYTE);
        std::vector<double> values(found && found->size <= most_numbers ? found->size : 0);
        const bool is_read = !values.empty() && nc_get_var_double(file_, found->number, values.data()) == NC_NOERR;
        into.add(std::uint64_t{is_read ? values.size() : 0});
        for (std::size_t k = 0; is_read && k < values.size(); ++k)
            into.add(values[k]);
    }

    void words(const char* name, base::Packing& into) const {
        const auto found = variable(name, NC_STRING, NC_STRING);
        std::vector<char*> values(found && found->size <= most_words ? found->size : 0, nullptr);
        const bool is_read = !values.empty() && nc_get_var_string(file_, found->number, values.data()) == NC_NOERR;
        into.add(std::uint64_t{is_read ? values.size() : 0});
        for (std::size_t k = 0; is_read && k < values.size(); ++k)
            into.add(std::string_view(values[k] == nullptr ? "" : values[k]));
    }

private:
    struct FoundVariable {
        int number = -1;
        std::size_t size = 0;
    };

    std::optional<FoundVariable> variable(const char* name, nc_type type, nc_type other) const {
        FoundVariable found;
        nc_type its = NC_NAT;
        int dimensions = 0;
        if (nc_inq_varid(file_, name, &found.number) != NC_NOERR ||
            nc_inq_vartype(file_, found.number, &its) != NC_NOERR || (its != type && its != other) ||
            nc_inq_varndims(file_, found.number, &dimensions) != NC_NOERR || dimensions < 1 || dimensions > 2)
            return std::nullopt;
        std::array<int, 2> numbers{};
        if (nc_inq_vardimid(file_, found.number, numbers.data()) != NC_NOERR) return std::nullopt;
        found.size = 1;
        for (int k = 0; k < dimensions; ++k) {
            std::size_t length = 0;
            if (nc_inq_dimlen(file_, numbers.at(static_cast<std::size_t>(k)), &length) != NC_NOERR || length == 0 ||
                length > most_numbers)
                return std::nullopt;
            found.size *= length;
        }
        return found;
    }

    int file_;
};

// runs where it may do nothing but read its file and answer
void answer(const base::ChildProcess::Channel& channel, std::uint64_t size) {
    constexpr int descriptor = 4;  // what a confined process gets
    std::string bytes(size, '\0');
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t got = ::pread(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (got <= 0) return;
        done += static_cast<std::size_t>(got);
    }
    int file = -1;
    base::Packing packing;
    if (nc_open_mem("part.nc", NC_NOWRITE, bytes.size(), bytes.data(), &file) == NC_NOERR) {
        const OpenedPart opened(file);
        for (const char* name : said)
            opened.text(name, packing);
        for (const char* name : numeric)
            opened.numbers(name, packing);
        for (const char* name : worded)
            opened.words(name, packing);
        opened.text(checksum_name, packing);
    }
    const std::string text = packing.take();
    const std::uint64_t length = text.size();
    channel.send(std::as_bytes(std::span(&length, 1)));
    channel.send(std::as_bytes(std::span(text)));
}

std::optional<PartContent> unpacked(const std::string& text) {
    base::Unpacking unpacking(text);
    PartContent found;
    for (const char* name : said)
        found.texts[name] = unpacking.words();
    for (const char* name : numeric) {
        const std::uint64_t count = unpacking.count();
        for (std::uint64_t k = 0; k < count && unpacking.is_good(); ++k)
            found.numbers[name].push_back(unpacking.number());
    }
    for (const char* name : worded) {
        const std::uint64_t count = unpacking.count();
        for (std::uint64_t k = 0; k < count && unpacking.is_good(); ++k)
            found.words[name].push_back(unpacking.words());
    }
    found.texts[checksum_name] = unpacking.words();
    return unpacking.is_complete() ? std::optional(std::move(found)) : std::nullopt;
}

PartContent asked(const std::string& path) {
    const auto bytes = recordings::open_plain_bytes(path);
    const auto descriptor = bytes->descriptor();
    if (!descriptor || bytes->size() > largest_file) throw recordings::refusal(path, "it is no reduced part");
    base::ChildProcess process(
        // the largest part takes a second; a damaged file may send the library round in circles
        base::Confines{.memory = std::uint64_t{8} << 30U, .processor_time = 20, .patience = 60, .file = *descriptor},
        [&](const base::ChildProcess::Channel& channel) { answer(channel, bytes->size()); });
    std::uint64_t length = 0;
    std::string text;
    bool is_whole = process.receive(std::as_writable_bytes(std::span(&length, 1))) && length <= longest_answer;
    if (is_whole) {
        text.resize(length);
        is_whole = process.receive(std::as_writable_bytes(std::span(text)));
    }
    if (!is_whole) {
        const std::string ending = process.ending();
        if (process.was_not_confined())
            throw Error(ErrorKind::io, {"no netCDF file is read on this machine",
                                        "it does not let a process be confined (seccomp)", ""});
        throw recordings::refusal(path, "the file is damaged", "reading it, " + ending);
    }
    auto found = unpacked(text);
    if (!found || found->texts["schema"] != schema)
        throw recordings::refusal(path, "it is no reduced part",
                                  "its schema is not " + std::string(schema) + ", or it is damaged",
                                  "Make one with `stridor structure reduce`.");
    // a part that was written before there were checksums is taken as it is
    const std::string& written = found->texts[checksum_name];
    if (!written.empty() && written != checksum_of(*found))
        throw recordings::refusal(path, "the file is damaged", "what it holds is not what was written into it",
                                  "Copy it again, or make it anew with `stridor structure reduce`.");
    return std::move(*found);
}

std::vector<RowLabel> labels_in(PartContent& found, const std::string& prefix) {
    const std::vector<std::string>& nodes = found.words[prefix + "_node"];
    const std::vector<double>& components = found.numbers[prefix + "_component"];
    std::vector<RowLabel> labels;
    for (std::size_t k = 0; k < nodes.size() && nodes.size() == components.size(); ++k) {
        const bool is_known = components[k] >= 0.0 && components[k] <= 6.0;
        labels.push_back({nodes[k], is_known ? static_cast<int>(components[k]) : -1});
    }
    return labels;
}

Eigen::MatrixXd matrix_in(const PartContent& found, const char* name, std::size_t rows, std::size_t columns,
                          const std::string& path) {
    const auto values = found.numbers.find(name);
    const std::size_t size = values == found.numbers.end() ? 0 : values->second.size();
    if (size != rows * columns)
        throw recordings::refusal(path, fmt::format("its {} has {} numbers", name, size),
                                  fmt::format("{} rows and {} columns need {}", rows, columns, rows * columns));
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                values->second[row * columns + column];
    return matrix;
}

void take_nodes(ElasticPart& part, PartContent& found, const std::string& path) {
    const std::vector<std::string>& nodes = found.words["node"];
    if (nodes.empty()) return;
    const std::vector<std::string>& sets = found.words["node_sets"];
    const Eigen::MatrixXd places = matrix_in(found, "position", nodes.size(), 3, path);
    structure::SetTable table;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        part.positions[nodes[k]] = places.row(static_cast<Eigen::Index>(k)).transpose();
        const std::string its = k < sets.size() ? sets[k] : std::string();
        for (std::size_t from = its.find_first_not_of(' '); from < its.size();) {
            const std::size_t end = std::min(its.find(' ', from), its.size());
            const std::string name = its.substr(from, end - from);
            const std::size_t place = table.place_of(name, name);
            if (const auto problem = table.excess(1))
                throw recordings::refusal(path, problem->what, problem->why, problem->suggestion);
            table.add(place, nodes[k]);
            from = std::min(its.find_first_not_of(' ', end), its.size());
        }
    }
    part.sets = table.take();
}

}  // namespace

Reduction read_reduced_part(const std::string& path) {
    PartContent found = asked(path);
    Reduction reduction;
    ElasticPart& part = reduction.part;
    part.labels = labels_in(found, "row");
    const std::size_t rows = part.labels.size();
    if (rows == 0) throw recordings::refusal(path, "it has no rows", "a reduced part names a node for each");
    part.stiffness = matrix_in(found, "stiffness", rows, rows, path).sparseView(0.0, 0.0);
    part.mass = matrix_in(found, "mass", rows, rows, path).sparseView(0.0, 0.0);
    if (!found.numbers["damping"].empty())
        part.damping = matrix_in(found, "damping", rows, rows, path).sparseView(0.0, 0.0);
    reduction.mode_frequencies = found.numbers["mode_frequency"];
    if (reduction.mode_frequencies.size() > rows)
        throw recordings::refusal(path, "it has more modes than rows", "each mode is a row");
    reduction.boundary_rows = static_cast<Eigen::Index>(rows - reduction.mode_frequencies.size());
    reduction.inertia = BoundaryInertia::consistent;
    for (const BoundaryInertia each : {BoundaryInertia::lumped, BoundaryInertia::consistent, BoundaryInertia::massless})
        if (found.texts["contact_inertia"] == name_of(each)) reduction.inertia = each;
    if (found.texts["method"] == name_of(ReductionMethod::macneal)) reduction.method = ReductionMethod::macneal;
    reduction.recovered = labels_in(found, "recovered");
    if (!reduction.recovered.empty())
        reduction.recovery = matrix_in(found, "recovery", reduction.recovered.size(), rows, path);
    take_nodes(part, found, path);
    return reduction;
}

}  // namespace stridor::io
