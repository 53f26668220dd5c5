#include "stridor/recordings/table/column_roles.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/refusal.hpp"
#include "stridor/recordings/table/table_start.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::recordings::signal_table {

namespace {

// "hh:mm:ss.mmm" is how a time is written
bool has_unit_of_time(const SignalColumn& column) {
    return unit_of_label(column.unit).unit == "s" || csv_table::lower(column.unit).starts_with("hh:mm");
}

// T may be the temperature, and t anything
bool is_time_word(const SignalColumn& column) {
    return csv_table::is_time_name(column.name) && column.name.size() > 1;
}

// a time in what is no unit: "samples", "-"
bool has_unknown_unit_of_time(const SignalColumn& column) {
    if (!is_time_word(column) || column.unit.empty() || has_unit_of_time(column)) return false;
    const std::string unit = unit_of_label(column.unit).unit;
    return !is_known_unit(column.unit) || unit == signal::full_scale || unit == "1";
}

std::string quoted(const TableHeader& header, std::size_t k) {
    const std::string& name = header.columns[k].name;
    return name.empty() ? "column " + std::to_string(k + 1) : "the column \"" + name + "\"";
}

/// Gives the columns their roles, one kind after the other.
class Roles {
public:
    Roles(TableHeader& header, const TableSurvey& survey, const RoleHints& hints)
        : header_(header),
          survey_(survey),
          hints_(hints) {}

    std::vector<std::string> assign() {
        find_time();
        leave_out_other_times();
        leave_out_unread();
        leave_out_counters();
        check_wanted();
        expect_signal();
        return std::move(notes_);
    }

private:
    std::size_t width() const { return header_.columns.size(); }

    bool is_channel(std::size_t k) const { return header_.columns[k].role == Role::channel; }

    void leave_out(std::size_t k, Role role, const std::string& why) {
        header_.columns[k].role = role;
        header_.columns[k].why = why.ends_with(',') ? why.substr(0, why.size() - 1) : why;
        notes_.push_back(quoted(header_, k) + " " + why + " and was left out");
    }

    // a column of times that holds any, the named ones first
    void find_time() {
        std::vector<std::size_t> candidates;
        for (std::size_t k = 0; k < width(); ++k)
            if (is_named_time(k)) candidates.push_back(k);
        for (std::size_t k = 0; k < width(); ++k)
            if (has_unit_of_time(header_.columns[k]) && !is_named_time(k)) candidates.push_back(k);
        const auto is_good = [&](std::size_t k) { return survey_.is_whole(k) && survey_.columns[k].is_rising; };
        auto found = std::find_if(candidates.begin(), candidates.end(), is_good);
        // what is called a time and is damaged or does not rise is refused where it is so
        if (found == candidates.end())
            found = std::find_if(candidates.begin(), candidates.end(),
                                 [&](std::size_t k) { return is_named_time(k) && survey_.columns[k].numbers > 0; });
        if (found != candidates.end()) {
            time_ = *found;
        } else {
            refuse_unknown_unit();
            if (!header_.has_names && !hints_.is_rate_known) time_ = first_of_two();
        }
        if (!time_) return;
        header_.columns[*time_].role = Role::time;
        if (!survey_.is_whole(*time_)) refuse_field(*time_, "A time is needed in every row.");
    }

    // without names the first of two columns of numbers is the time, unless it only counts
    std::optional<std::size_t> first_of_two() const {
        std::optional<std::size_t> first;
        for (std::size_t k = 0; k < width(); ++k) {
            if (survey_.columns[k].numbers == 0 || (!survey_.is_whole(k) && k > 0)) continue;
            if (first) return is_counter(*first) ? std::nullopt : first;
            first = k;
        }
        return std::nullopt;
    }

    bool is_named_time(std::size_t k) const {
        const SignalColumn& column = header_.columns[k];
        return csv_table::is_time_name(column.name) && (column.unit.empty() || has_unit_of_time(column));
    }

    // taken for seconds they would be wrong by a thousand and more
    void refuse_unknown_unit() const {
        for (std::size_t k = 0; k < width(); ++k) {
            const SignalColumn& column = header_.columns[k];
            if (has_unknown_unit_of_time(column) && !hints_.is_rate_known)
                throw refusal({hints_.file, header_.names_number, 0, ""},
                              "the times of \"" + column.name + "\" are in \"" + column.unit + "\"",
                              "that is no unit of time that is known",
                              "Write s, ms, us, ns, min or h into the heading, or say the sampling rate with --rate.");
        }
    }

    [[noreturn]] void refuse_field(std::size_t k, const std::string& suggestion) const {
        const ColumnSurvey& column = survey_.columns[k];
        const std::string& name = header_.columns[k].name;
        const std::string what = (name.empty() ? "" : name + " = ") + "\"" + column.trouble_text + "\"";
        const bool is_number = csv_table::number_in(column.trouble_text, header_.dialect).has_value();
        const bool has_comma = column.trouble_text.find(',') != std::string::npos;
        const std::string why = column.trouble_text.empty() ? "the field is empty"
                                : is_number ? "instruments write such numbers for an overload, or for no value"
                                            : "";
        throw refusal(*column.trouble, what + (is_number ? " is no finite sample" : " is not a number"), why,
                      has_comma ? "Write the decimal mark as a point." : suggestion);
    }

    void leave_out_other_times() {
        bool is_of_other_times = false;  // in LabVIEW's tables a time stands before each channel
        for (std::size_t k = 0; k < width(); ++k) {
            if (k == time_) {
                is_of_other_times = false;
                continue;
            }
            const bool is_other = is_named_time(k) || has_unit_of_time(header_.columns[k]) ||
                                  has_unknown_unit_of_time(header_.columns[k]);
            if (is_other && survey_.columns[k].numbers == 0) continue;
            if (is_other) {
                const bool is_alike = !time_ || are_same_times(k);
                is_of_other_times = !is_alike && is_named_time(k) && header_.columns[k].name == named(*time_);
                leave_out(k, Role::other_time, "is a time and no signal");
            } else if (is_of_other_times) {
                leave_out(k, Role::damaged, "has times of its own that differ from the first");
            }
        }
    }

    const std::string& named(std::size_t k) const { return header_.columns[k].name; }

    bool are_same_times(std::size_t k) const {
        const ColumnSurvey& a = survey_.columns[*time_];
        const ColumnSurvey& b = survey_.columns[k];
        const double a_unit =
            has_unit_of_time(header_.columns[*time_]) ? unit_of_label(header_.columns[*time_].unit).value : 1.0;
        const double b_unit = has_unit_of_time(header_.columns[k]) ? unit_of_label(header_.columns[k].unit).value : 1.0;
        const double step = (a.second - a.first) * a_unit;
        const double span = (a.last - a.first) * a_unit;
        return b.numbers == a.numbers && std::abs((b.last - b.first) * b_unit - span) <= 0.5 * step;
    }

    void leave_out_unread() {
        for (std::size_t k = 0; k < width(); ++k) {
            if (!is_channel(k)) continue;
            const ColumnSurvey& column = survey_.columns[k];
            const std::uint64_t rows = survey_.rows;
            if (column.empty == rows) {
                leave_out(k, Role::empty, "is empty");
            } else if (column.numbers == 0 && !csv_table::number_in(column.trouble_text, header_.dialect)) {
                leave_out(k, Role::words, "holds words");
            } else if (!survey_.is_whole(k)) {
                leave_out(k, Role::damaged,
                          "has no number in " + std::to_string(rows - column.numbers) + " of " + std::to_string(rows) +
                              " rows (first in line " + std::to_string(column.trouble->line) + ": \"" +
                              column.trouble_text + "\")");
            } else if (is_marked(column)) {
                leave_out(k, Role::damaged,
                          "holds " + base::shortest(column.mark) + ", a mark for no value, in " +
                              std::to_string(column.marks) + " of " + std::to_string(rows) + " rows");
            }
        }
    }

    static bool is_marked(const ColumnSurvey& column) {
        constexpr double beyond = 50.0;  // [1] nothing that is measured stands out so much
        return column.marks > 0 && column.marks < column.numbers && std::abs(column.mark) > beyond * column.largest;
    }

    // no sound grows by the same step from its first sample to its last
    bool is_counter(std::size_t k) const {
        const ColumnSurvey& column = survey_.columns[k];
        const bool is_whole_step =
            column.first == std::round(column.first) && column.second == std::round(column.second);
        const std::string& unit = header_.columns[k].unit;
        return (unit.empty() || !is_known_unit(unit)) && column.numbers > 2 && column.is_even && column.is_rising &&
               (is_whole_step || header_.has_names || hints_.is_rate_known);
    }

    void leave_out_counters() {
        const auto is_signal = [&](std::size_t k) { return is_channel(k) && !is_counter(k); };
        std::size_t signals = 0;
        for (std::size_t k = 0; k < width(); ++k)
            signals += is_signal(k) ? 1U : 0U;
        for (std::size_t k = 0; k < width(); ++k)
            if (signals > 0 && is_channel(k) && is_counter(k))
                leave_out(k, Role::counter, "grows by the same step in every row, as a counter or a time does,");
    }

    void check_wanted() const {
        for (std::size_t k = 0; k < width(); ++k) {
            const Role role = header_.columns[k].role;
            const bool is_wanted = !hints_.wanted.empty() && named(k) == hints_.wanted;
            if (is_wanted && survey_.columns[k].trouble && role != Role::channel)
                refuse_field(k, "Give every row a number, or cut the table to the rows that have one.");
        }
    }

    void expect_signal() const {
        for (std::size_t k = 0; k < width(); ++k)
            if (is_channel(k)) return;
        for (std::size_t k = 0; k < width(); ++k)
            if ((header_.columns[k].role == Role::damaged || header_.columns[k].role == Role::words) &&
                survey_.columns[k].trouble)
                refuse_field(k, "Give every row a number, or cut the table to the rows that have one.");
        std::string why;
        for (const std::string& note : notes_)
            why += (why.empty() ? "" : "; ") + note;
        throw refusal({hints_.file, header_.data_number, 0, ""}, "the table has no column of samples", why);
    }

    TableHeader& header_;
    const TableSurvey& survey_;
    const RoleHints& hints_;
    std::vector<std::string> notes_{};
    std::optional<std::size_t> time_{};
};

}  // namespace

std::vector<std::string> assign_roles(TableHeader& header, const TableSurvey& survey, const RoleHints& hints) {
    return Roles(header, survey, hints).assign();
}

std::optional<std::size_t> time_column(const TableHeader& header) {
    for (std::size_t k = 0; k < header.columns.size(); ++k)
        if (header.columns[k].role == Role::time) return k;
    return std::nullopt;
}

}  // namespace stridor::recordings::signal_table
