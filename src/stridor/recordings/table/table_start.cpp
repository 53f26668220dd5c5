#include "stridor/recordings/table/table_start.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace stridor::recordings::csv_table {

namespace {

std::vector<CsvField> fields_of(const std::string& line, Dialect dialect) {
    return split(line, dialect.delimiter);
}

bool is_number(const CsvField& field, Dialect dialect) {
    return value_in(field.text, dialect).has_value();
}

// a list of channels above the table may begin its lines with numbers, too, but holds mostly words
bool is_row(const std::vector<CsvField>& fields, Dialect dialect) {
    const auto first =
        std::find_if(fields.begin(), fields.end(), [](const CsvField& field) { return !field.text.empty(); });
    if (first == fields.end() || !is_number(*first, dialect)) return false;
    const auto count = [&](auto is_counted) { return std::count_if(fields.begin(), fields.end(), is_counted); };
    const auto numbers = count([&](const CsvField& field) { return is_number(field, dialect); });
    return 2 * numbers > count([](const CsvField& field) { return !field.text.empty(); });
}

// T is the tesla, too
bool names_a_time(const std::vector<CsvField>& fields) {
    return std::any_of(fields.begin(), fields.end(), [](const CsvField& field) {
        const Title title = title_of(field.text);
        const bool has_unit = !title.name.empty() && unit_of_label(title.unit).unit == "s";  // "[s]" is a unit itself
        return (is_time_name(title.name) && title.name != "T") || has_unit;
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

// "acc [m/s^2]" is a name with its unit, and no unit
bool holds_titles(const std::vector<CsvField>& fields) {
    return std::any_of(fields.begin(), fields.end(), [](const CsvField& field) {
        const Title title = title_of(field.text);
        return !title.name.empty() && !title.unit.empty() && is_known_unit(title.unit);
    });
}

class Finder {
public:
    Finder(std::span<const std::string> lines, Dialect dialect) : lines_(lines), dialect_(dialect) {
        for (const std::string& line : lines) {
            std::vector<CsvField> fields = fields_of(line, dialect);
            drop_empty_tail(fields, 1);
            if (fields.size() > 1 && lower(fields.back().text) == "comment") commented_ = fields.size() - 1;
        }
    }

    std::optional<TableStart> find() {
        find_rows();
        if (rows_ == lines_.size()) return std::nullopt;
        // rows above a row that is damaged are no prose: the reader of rows will say where it is
        for (std::size_t k = 0; k < rows_; ++k)
            if (const auto fields = row_in(k);
                filled(fields) == filled_ && fields.size() >= filled_ && is_row(fields, dialect_))
                return std::nullopt;
        TableStart start{dialect_, {}, {}, rows_, filled_, false};
        if (rows_ > 0) find_names(start);
        // a line of text and one of numbers may be anything
        const bool is_sure = start.first() == 0 || (rows_ > 2 && lines_.size() - rows_ > 1);
        const bool is_short = rows_ <= 2 && start.names.has_value();
        return is_sure || is_short || is_below_facts() ? std::optional(start) : std::nullopt;
    }

private:
    std::vector<CsvField> above(std::size_t lines) const {
        return split_names(lines_[rows_ - lines], dialect_.delimiter, filled_);
    }

    // without its remark
    std::vector<CsvField> row_in(std::size_t line) const {
        std::vector<CsvField> fields = fields_of(lines_[line], dialect_);
        if (commented_ > 0 && fields.size() == commented_ + 1) fields.pop_back();
        return fields;
    }

    // "Sampling rate: 8000 Hz" above rows of several fields is a fact, and no name of theirs
    bool is_below_facts() const {
        const auto is_fact = [&](const std::string& line) {
            return filled(fields_of(line, dialect_)) == 1 && line.find_first_of(":=") != std::string::npos;
        };
        return filled_ > 1 && lines_.size() - rows_ > 2 &&
               std::all_of(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(rows_), is_fact);
    }

    // fields at the end of a row may be empty, so that rows differ in those that are filled
    void find_rows() {
        rows_ = lines_.size();
        std::size_t narrowest = std::numeric_limits<std::size_t>::max();
        while (rows_ > 0) {
            const std::vector<CsvField> fields = row_in(rows_ - 1);
            if (!is_row(fields, dialect_)) break;
            const std::size_t wide = std::max(filled_, filled(fields));
            if (wide > std::min(narrowest, fields.size())) break;
            filled_ = wide;
            narrowest = std::min(narrowest, fields.size());
            --rows_;
        }
        narrowest_ = narrowest;
        if (rows_ < lines_.size()) take_rows_beside_facts();
    }

    // ",,,-0.00998,0.0016" below "Record Length,2500,,-0.01,0.0008": older oscilloscopes put facts left of the first
    // rows
    void take_rows_beside_facts() {
        const std::vector<CsvField> last = fields_of(lines_.back(), dialect_);
        const auto first = std::find_if(last.begin(), last.end(), [](const CsvField& f) { return !f.text.empty(); });
        if (first == last.begin()) return;
        const auto numbers_from = static_cast<std::size_t>(first - last.begin());
        while (rows_ > 0) {
            const std::vector<CsvField> fields = row_in(rows_ - 1);
            if (filled(fields) != filled_) return;
            for (std::size_t k = numbers_from; k < filled_; ++k)
                if (!is_number(fields[k], dialect_)) return;
            narrowest_ = std::min(narrowest_, fields.size());
            --rows_;
        }
    }

    // how many names a line holds, if it may be one: as wide as the rows
    std::optional<std::size_t> width_of(std::vector<CsvField> fields) const {
        drop_empty_tail(fields, 1);
        drop_comment(fields, narrowest_);
        const bool is_wide = fields.size() >= filled_ && fields.size() <= narrowest_;
        return is_wide ? std::optional(fields.size()) : std::nullopt;
    }

    // without numbers: "1" is a unit, and channels may be called by their number
    bool fits(std::vector<CsvField> fields) const {
        if (!width_of(fields)) return false;
        const auto is_foreign = [&](const CsvField& field) { return field.text != "1" && is_number(field, dialect_); };
        return !is_number(fields.front(), dialect_) &&
               (names_a_time(fields) || std::none_of(fields.begin(), fields.end(), is_foreign));
    }

    // "Sequence,Volt,-6e-4,1e-6" below "X,CH1,Start,Increment": units, and facts beyond the rows
    bool holds_facts(const std::vector<CsvField>& fields) const {
        if (fields.size() <= filled_) return false;
        const auto edge = fields.begin() + static_cast<std::ptrdiff_t>(filled_);
        const auto is_a_number = [&](const CsvField& field) { return is_number(field, dialect_); };
        return std::none_of(fields.begin(), edge, is_a_number) && std::any_of(edge, fields.end(), is_a_number);
    }

    void find_names(TableStart& start) const {
        const bool has_second = rows_ > 1 && fits(above(2));
        if (has_second && holds_facts(above(1))) {
            start.names = rows_ - 2;
            start.units = rows_ - 1;
        } else if (fits(above(1))) {
            start.names = rows_ - 1;
            const bool has_units =
                has_second && !holds_titles(above(1)) &&
                (rows_ > 2 ? looks_like_units(above(1)) : !names_a_time(above(1)) || names_a_time(above(2)));
            if (has_units) {
                start.names = rows_ - 2;
                start.units = rows_ - 1;
            }
        }
        if (!start.names) return;
        start.width = width_of(above(rows_ - *start.names)).value_or(filled_);
        start.has_comment = commented_ > 0 && start.width == commented_;
    }

    std::span<const std::string> lines_;
    Dialect dialect_;
    std::size_t rows_ = 0;
    std::size_t filled_ = 0;     // of the widest row
    std::size_t commented_ = 0;  // fields before LabVIEW's remark; 0: the names have none
    std::size_t narrowest_ = 0;  // fields of the narrowest row, empty ones too
};

// which mark is the decimal one, and which one parts thousands
void look_for_marks(std::span<const std::string> lines, Dialect& dialect) {
    bool has_commas = false;
    bool has_points = false;
    for (const std::string& line : lines)
        for (const CsvField& field : fields_of(line, dialect)) {
            has_commas |= tells_decimal(field, ',');
            has_points |= tells_decimal(field, '.');
        }
    dialect.has_quoted_decimals = dialect.delimiter == ',' && has_commas;
    dialect.grouping = has_commas == has_points ? '\0' : has_commas ? '.' : ',';
}

// what parts the rows that end with the last of these lines
std::optional<TableStart> found_by(std::span<const std::string> lines, Dialect dialect) {
    if (dialect.delimiter == ',') look_for_marks(lines, dialect);
    std::optional<TableStart> found = Finder(lines, dialect).find();
    if (found && dialect.delimiter != ',') look_for_marks(lines.subspan(found->rows), found->dialect);
    return found;
}

std::optional<TableStart> start_before(std::span<const std::string> lines) {
    const bool has_delimiter = lines.back().find_first_of("\t;,") != std::string::npos;
    const Dialect dialect = has_delimiter ? sniff(lines.back()) : Dialect{'\0'};
    const std::optional<TableStart> found = found_by(lines, dialect);
    if (found && (dialect.delimiter == '\t' || dialect.delimiter == ';')) return found;
    // a comma may be a decimal mark: then nothing parts the names
    const std::optional<TableStart> single = found_by(lines, {'\0'});
    const bool is_single =
        single && single->names && lines[single->rows - 1].find_first_of("\t;,") == std::string::npos;
    if (is_single) return single;
    if (has_delimiter && found) return found;
    const bool has_blanks = base::trimmed(lines.back()).find_first_of(" \t") != std::string_view::npos;
    return has_blanks ? found_by(lines, {' '}) : std::nullopt;
}

}  // namespace

std::optional<TableStart> find_start(std::span<const std::string> lines) {
    constexpr std::size_t most_behind = 20;  // lines of text behind a short table
    for (std::size_t behind = 0; behind < std::min(most_behind, lines.size()); ++behind)
        if (auto found = start_before(lines.first(lines.size() - behind))) return found;
    return std::nullopt;
}

void drop_comment(std::vector<CsvField>& names, std::size_t width) {
    const bool has_one = names.size() == width + 1 && !names.empty() && lower(names.back().text) == "comment";
    if (has_one) names.pop_back();
}

bool is_time_name(std::string_view name) {
    constexpr std::array<std::string_view, 15> known{
        "time",      "t",         "zeit",         "temps",      "tiempo",
        "x_value",   "timestamp", "time stamp",   "time_stamp", "elapsed time",
        "test time", "elapsed",   "elapsed_time", "step time",  "x-axis"};
    return std::find(known.begin(), known.end(), lower(base::trimmed(name))) != known.end();
}

}  // namespace stridor::recordings::csv_table
