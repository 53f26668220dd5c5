#include "stridor/recordings/mat/matio_answers.hpp"

#include "stridor/recordings/mat/mat_answers.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

namespace {

using base::ChildProcess;

/// A variable of the file; `info` lives as long as the process.
struct Found {
    matvar_t* info = nullptr;
    std::string name{};  // "s.signals(2).values" of a field
    mat::VariableHead head{};
    bool is_loaded = false;
};

mat::MatKind kind_of(const matvar_t& info) {
    if (info.class_type == MAT_C_SPARSE) return mat::MatKind::sparse;
    if (info.class_type == MAT_C_CHAR) return mat::MatKind::text;
    if (info.class_type == MAT_C_CELL) return mat::MatKind::cells;
    if (info.class_type == MAT_C_STRUCT) return mat::MatKind::structure;
    const bool is_number = info.class_type >= MAT_C_DOUBLE && info.class_type <= MAT_C_UINT64;
    if (!is_number) return mat::MatKind::object;
    if (info.isComplex != 0) return mat::MatKind::complex;
    if (info.isLogical != 0) return mat::MatKind::truth_values;
    if (info.class_type == MAT_C_DOUBLE) return mat::MatKind::doubles;
    return info.class_type == MAT_C_SINGLE ? mat::MatKind::singles : mat::MatKind::integers;
}

// a dimension of one does not count, but two are always there
mat::VariableHead head_of(const matvar_t& info) {
    mat::VariableHead head;
    head.kind = kind_of(info);
    std::vector<std::uint64_t> sizes(info.dims, info.dims + std::max(info.rank, 0));
    for (std::size_t k = sizes.size(); k > 0 && sizes.size() > 2; --k)
        if (sizes[k - 1] == 1) sizes.erase(sizes.begin() + static_cast<std::ptrdiff_t>(k - 1));
    if (sizes.size() > 2)
        head.kind = mat::MatKind::several_dimensions;
    else if (sizes.size() < 2 || sizes[0] == 0 || sizes[1] == 0)
        head.kind = mat::MatKind::nothing;
    else {
        head.rows = sizes[0];
        head.columns = sizes[1];
    }
    return head;
}

template <typename Number>
double number_at(const matvar_t& info, std::size_t index) {
    Number number{};
    std::memcpy(&number, static_cast<const char*>(info.data) + index * sizeof number, sizeof number);
    return static_cast<double>(number);
}

double value_at(const matvar_t& info, std::size_t index) {
    switch (info.class_type) {
        case MAT_C_DOUBLE:
            return number_at<double>(info, index);
        case MAT_C_SINGLE:
            return number_at<float>(info, index);
        case MAT_C_INT8:
            return number_at<std::int8_t>(info, index);
        case MAT_C_UINT8:
            return number_at<std::uint8_t>(info, index);
        case MAT_C_INT16:
            return number_at<std::int16_t>(info, index);
        case MAT_C_UINT16:
            return number_at<std::uint16_t>(info, index);
        case MAT_C_INT32:
            return number_at<std::int32_t>(info, index);
        case MAT_C_UINT32:
            return number_at<std::uint32_t>(info, index);
        case MAT_C_INT64:
            return number_at<std::int64_t>(info, index);
        default:
            return number_at<std::uint64_t>(info, index);
    }
}

std::size_t size_of(const matvar_t& info) {
    constexpr std::array<std::size_t, 10> sizes{8, 4, 1, 1, 2, 2, 4, 4, 8, 8};  // from MAT_C_DOUBLE on
    return sizes.at(static_cast<std::size_t>(info.class_type - MAT_C_DOUBLE));
}

bool is_number(mat::MatKind kind) {
    return kind == mat::MatKind::doubles || kind == mat::MatKind::singles || kind == mat::MatKind::integers;
}

bool load(const Matio& matio, mat_t* file, Found& found) {
    if (found.is_loaded) return true;
    if (!is_number(found.head.kind) || matio.read_all_data(file, found.info) != 0) return false;
    const std::uint64_t bytes = found.head.rows * found.head.columns * size_of(*found.info);
    found.is_loaded = found.info->data != nullptr && found.info->nbytes >= bytes;
    return found.is_loaded;
}

template <typename Plain>
void send(const ChildProcess::Channel& channel, const Plain& plain) {
    channel.send(std::as_bytes(std::span(&plain, 1)));
}

template <typename Plain>
bool receive(const ChildProcess::Channel& channel, Plain& plain) {
    return channel.receive(std::as_writable_bytes(std::span(&plain, 1)));
}

constexpr int deepest_field = 4;             // Simulink's are s.signals(k).values
constexpr std::uint64_t most_elements = 64;  // of an array of structures: more are events, and no signals

// a variable, or the fields of a structure
void add(const Matio& matio, matvar_t& info, const std::string& name, std::vector<Found>& all, int depth) {
    const std::size_t before = all.size();
    const mat::VariableHead head = head_of(info);
    const bool is_structure = head.kind == mat::MatKind::structure && info.data != nullptr;
    const std::uint64_t elements = head.rows * head.columns;
    const bool is_opened = is_structure && depth < deepest_field && elements <= most_elements;
    const unsigned fields = is_opened ? matio.field_count(&info) : 0;
    const char* const* names = is_opened ? matio.field_names(&info) : nullptr;
    for (std::size_t element = 0; element < elements && names != nullptr; ++element)
        for (unsigned k = 0; k < fields && all.size() <= mat::most_variables; ++k) {
            matvar_t* field = matio.field(&info, k, element);
            const std::string index = elements > 1 ? "(" + std::to_string(element + 1) + ")" : "";
            if (field != nullptr && names[k] != nullptr)
                add(matio, *field, name + index + "." + names[k], all, depth + 1);
        }
    if (all.size() > before) return;
    all.push_back({&info, name.substr(0, mat::longest_name), head});
    all.back().head.name_length = static_cast<std::uint32_t>(all.back().name.size());
}

std::vector<Found> list(const Matio& matio, mat_t* file) {
    std::vector<Found> all;
    while (all.size() <= mat::most_variables) {
        matvar_t* info = matio.read_next_info(file);
        if (info == nullptr) break;
        add(matio, *info, info->name == nullptr ? "" : info->name, all, 0);
    }
    return all;
}

// the numbers of some columns, row by row; all of them are loaded and equally long
void send_columns(const ChildProcess::Channel& channel, const std::vector<Found>& all,
                  const std::vector<mat::MatColumn>& columns) {
    constexpr std::size_t block_size = 8192;
    struct Walk {
        const matvar_t* info;
        std::size_t next;
        std::size_t step;
    };
    std::vector<Walk> walks;
    for (const mat::MatColumn& column : columns) {
        const Found& found = all[column.variable];
        const std::size_t rows = found.head.rows;
        if (column.is_flat != 0)
            walks.push_back({found.info, column.index, rows});
        else
            walks.push_back({found.info, column.index * rows, 1});
    }
    const mat::VariableHead& head = all[columns.front().variable].head;
    const std::uint64_t frames = columns.front().is_flat != 0 ? head.columns : head.rows;
    std::vector<double> block;
    block.reserve(block_size + walks.size());
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        for (Walk& walk : walks) {
            block.push_back(value_at(*walk.info, walk.next));
            walk.next += walk.step;
        }
        if (block.size() < block_size && frame + 1 < frames) continue;
        channel.send(std::as_bytes(std::span(block)));
        block.clear();
    }
}

}  // namespace

const Matio* matio_library() {
    static const Matio opened;
    return opened.library.is_whole() ? &opened : nullptr;
}

void answer_with_matio(const Matio& matio, const ChildProcess::Channel& channel) {
    mat_t* file = matio.open(ChildProcess::file_path, MAT_ACC_RDONLY);
    if (file == nullptr) return send(channel, mat::Opened{});
    std::vector<Found> all = list(matio, file);
    send(channel, mat::Opened{1, static_cast<std::uint32_t>(all.size())});
    for (Found& found : all) {
        const bool is_single = is_number(found.head.kind) && found.head.rows == 1 && found.head.columns == 1;
        // what cannot be read is no number that anybody may use
        if (is_single && !load(matio, file, found)) found.head.kind = mat::MatKind::object;
        if (found.is_loaded) found.head.value = value_at(*found.info, 0);
        send(channel, found.head);
        channel.send(std::as_bytes(std::span(found.name)));
    }
    std::uint64_t count = 0;
    while (receive(channel, count)) {
        std::vector<mat::MatColumn> columns(count);
        if (!channel.receive(std::as_writable_bytes(std::span(columns)))) return;
        const bool is_read = std::all_of(columns.begin(), columns.end(), [&](const mat::MatColumn& column) {
            return load(matio, file, all.at(column.variable));
        });
        send(channel, std::uint32_t{is_read});
        if (is_read) send_columns(channel, all, columns);
    }
}

}  // namespace stridor::recordings
