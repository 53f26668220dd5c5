#include "stridor/recordings/table/table_start.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace stridor::recordings::csv_table {

namespace {

std::vector<CsvField> fields_of(const std::string& line, Dialect dialect) {
    std::vector<CsvField> fields = split(line, dialect.delimiter);
    drop_empty_tail(fields, 1);
    return fields;
}

bool is_number(const CsvField& field, Dialect dialect) {
    return number_in(field.text, dialect).has_value();
}

// a list of channels above the table may begin its lines with numbers, too, but holds mostly words
bool is_row(const std::vector<CsvField>& fields, Dialect dialect) {
    if (!is_number(fields.front(), dialect)) return false;
    const auto count = [&](auto is_counted) { return std::count_if(fields.begin(), fields.end(), is_counted); };
    const auto numbers = count([&](const CsvField& field) { return is_number(field, dialect); });
    return 2 * numbers > count([](const CsvField& field) { return !field.text.empty(); });
}

// T is the tesla, too
bool names_a_time(const std::vector<CsvField>& fields) {
    return std::any_of(fields.begin(), fields.end(), [](const CsvField& field) {
        const Title title = title_of(field.text);
        return (is_time_name(title.name) && title.name != "T") || unit_of_label(title.unit).unit == "s";
    });
}

bool looks_like_units(const std::vector<CsvField>& fields) {
    const auto is_unit = [](const CsvField& field) {
        const std::string_view bare = bare_unit(field.text);
        // "force [N]" is a name with its unit
        const bool is_bracketed = bare.size() < field.text.size() && title_of(field.text).name.empty();
        return is_bracketed || (!bare.empty() && is_known_unit(bare));
    };
    return !names_a_time(fields) && std::any_of(fields.begin(), fields.end(), is_unit);
}

class Finder {
public:
    Finder(std::span<const std::string> lines, Dialect dialect) : lines_(lines), dialect_(dialect) {}

    std::optional<TableStart> find() {
        find_rows();
        if (rows_ == lines_.size()) return std::nullopt;
        // rows above a row that is damaged are no prose: the reader of rows will say where it is
        for (std::size_t k = 0; k < rows_; ++k)
            if (const auto fields = fields_of(lines_[k], dialect_); fields.size() == width_ && is_row(fields, dialect_))
                return std::nullopt;
        TableStart start{dialect_, {}, {}, rows_};
        const bool is_named = rows_ > 0 && fits(above(1));
        if (is_named) find_names(start);
        // a line of text and one of numbers may be anything
        const bool is_sure = start.first() == 0 || (rows_ > 2 && lines_.size() - rows_ > 1);
        const bool is_short = rows_ <= 2 && start.names.has_value();
        return is_sure || is_short ? std::optional(start) : std::nullopt;
    }

private:
    std::vector<CsvField> above(std::size_t lines) const { return fields_of(lines_[rows_ - lines], dialect_); }

    void find_rows() {
        rows_ = lines_.size();
        while (rows_ > 0) {
            const std::vector<CsvField> fields = above(1);
            if (!is_row(fields, dialect_)) return;
            if (rows_ < lines_.size() && fields.size() != width_) return;
            width_ = fields.size();
            --rows_;
        }
    }

    // as wide as the rows, and without numbers: "1" is a unit, and channels may be called by their number
    bool fits(std::vector<CsvField> fields) const {
        drop_comment(fields, width_);
        const auto is_foreign = [&](const CsvField& field) { return field.text != "1" && is_number(field, dialect_); };
        return fields.size() == width_ && !is_number(fields.front(), dialect_) &&
               (names_a_time(fields) || std::none_of(fields.begin(), fields.end(), is_foreign));
    }

    void find_names(TableStart& start) const {
        start.names = rows_ - 1;
        if (rows_ < 2 || !fits(above(2))) return;
        const bool has_units =
            rows_ > 2 ? looks_like_units(above(1)) : !names_a_time(above(1)) || names_a_time(above(2));
        if (!has_units) return;
        start.names = rows_ - 2;
        start.units = rows_ - 1;
    }

    std::span<const std::string> lines_;
    Dialect dialect_;
    std::size_t rows_ = 0;
    std::size_t width_ = 0;
};

}  // namespace

std::optional<TableStart> find_start(std::span<const std::string> lines) {
    if (lines.empty()) return std::nullopt;
    const bool has_delimiter = lines.back().find_first_of("\t;,") != std::string::npos;
    const Dialect dialect = has_delimiter ? sniff(lines.back()) : Dialect{'\0'};
    const std::optional<TableStart> found = Finder(lines, dialect).find();
    if (dialect.delimiter == '\t' || dialect.delimiter == ';') return found;
    // a comma may be a decimal mark: then nothing parts the names
    const std::optional<TableStart> single = Finder(lines, {'\0'}).find();
    const bool is_single =
        single && single->names && lines[single->rows - 1].find_first_of("\t;,") == std::string::npos;
    if (is_single) return single;
    return has_delimiter ? found : std::nullopt;
}

void drop_comment(std::vector<CsvField>& names, std::size_t width) {
    const bool has_one = names.size() == width + 1 && lower(names.back().text) == "comment";
    if (has_one) names.pop_back();
}

bool is_time_name(std::string_view name) {
    constexpr std::array<std::string_view, 6> known{"time", "t", "zeit", "temps", "tiempo", "x_value"};
    return std::find(known.begin(), known.end(), lower(base::trimmed(name))) != known.end();
}

}  // namespace stridor::recordings::csv_table
