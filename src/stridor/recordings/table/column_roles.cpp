#include "stridor/recordings/table/column_roles.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/table_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

// a count has no unit: "-", "1", "#" and words are none
bool has_no_unit(const SignalColumn& column) {
    return column.unit.empty() || column.unit == "1" || unit_as_written(column.unit) == "-" ||
           !is_known_unit(column.unit);
}

// what parts the fields, where what is read as one is none
std::string why_no_number(const std::string& text) {
    if (text.find('|') != std::string::npos) return "\"|\" parts no columns; tabs, semicolons, commas and blanks do";
    const bool are_numbers = text.find_first_not_of("0123456789.+-eE \t") == std::string::npos &&
                             std::count(text.begin(), text.end(), '.') > 1;
    return are_numbers ? "its numbers touch: blanks, tabs, semicolons or commas part columns" : "";
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
        leave_out_other_steps();
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

    // columns that may be times, the likeliest first
    std::vector<std::size_t> candidates() const {
        std::vector<std::size_t> found;
        const auto add = [&](auto is_wanted) {
            for (std::size_t k = 0; k < width(); ++k)
                if (is_wanted(k) && std::find(found.begin(), found.end(), k) == found.end()) found.push_back(k);
        };
        add([&](std::size_t k) { return is_named_time(k) && has_unit_of_time(header_.columns[k]); });
        add([&](std::size_t k) { return is_named_time(k) && !may_be_temperature(k); });
        add([&](std::size_t k) { return is_named_time(k); });
        add([&](std::size_t k) { return has_unit_of_time(header_.columns[k]); });
        return found;
    }

    void find_time() {
        const std::vector<std::size_t> likely = candidates();
        const auto is_good = [&](std::size_t k) { return survey_.is_whole(k) && survey_.columns[k].is_rising; };
        auto found = std::find_if(likely.begin(), likely.end(), is_good);
        // what is called a time and is damaged or does not rise is refused where it is so
        if (found == likely.end())
            found = std::find_if(likely.begin(), likely.end(), [&](std::size_t k) {
                return is_named_time(k) && !may_be_temperature(k) && survey_.columns[k].numbers > 0;
            });
        if (found != likely.end()) {
            time_ = *found;
        } else {
            refuse_unknown_unit();
            if (!header_.has_names && !hints_.is_rate_given) time_ = first_of_two();
        }
        if (time_ && !survey_.is_whole(*time_) && hints_.is_rate_given) time_.reset();
        if (!time_) return;
        header_.columns[*time_].role = Role::time;
        if (!survey_.is_whole(*time_))
            refuse_field(*time_, "A time is needed in every row, or the sampling rate: --rate 48000.");
    }

    // without names the first of two columns of numbers is the time, unless it only counts
    std::optional<std::size_t> first_of_two() const {
        std::optional<std::size_t> first;
        for (std::size_t k = 0; k < width(); ++k) {
            if (survey_.columns[k].numbers == 0 || (!survey_.is_whole(k) && k > 0)) continue;
            if (first) return is_first_time(*first) ? first : std::nullopt;
            first = k;
        }
        return std::nullopt;
    }

    // it is held against a rate that is said where it grows as times do
    bool is_first_time(std::size_t k) const {
        const ColumnSurvey& column = survey_.columns[k];
        const bool is_even = column.is_rising && column.is_even;
        const bool is_count = (is_even && has_whole_step(column)) || counts_by_one(column);
        return !is_count && (is_even || !hints_.is_rate_said);
    }

    static bool has_whole_step(const ColumnSurvey& column) {
        return column.first == std::round(column.first) && column.second == std::round(column.second);
    }

    bool may_be_temperature(std::size_t k) const {
        const SignalColumn& column = header_.columns[k];
        return column.name == "T" && column.unit.empty();
    }

    bool is_named_time(std::size_t k) const {
        const SignalColumn& column = header_.columns[k];
        return csv_table::is_time_name(column.name) && (column.unit.empty() || has_unit_of_time(column));
    }

    // taken for seconds they would be wrong by a thousand and more
    void refuse_unknown_unit() const {
        for (std::size_t k = 0; k < width(); ++k) {
            const SignalColumn& column = header_.columns[k];
            if (has_unknown_unit_of_time(column) && !hints_.is_rate_given && !hints_.is_rate_said)
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
                                            : why_no_number(column.trouble_text);
        throw refusal(*column.trouble, what + (is_number ? " is no finite sample" : " is not a number"), why,
                      has_comma ? "Write the decimal mark as a point." : suggestion);
    }

    void leave_out_other_times() {
        bool is_of_other_times = false;  // a time may stand before each channel, or before some
        for (std::size_t k = 0; k < width(); ++k) {
            if (k == time_) {
                is_of_other_times = false;
                continue;
            }
            const bool is_time = is_named_time(k) || has_unit_of_time(header_.columns[k]);
            const bool is_other = is_time || has_unknown_unit_of_time(header_.columns[k]);
            if (is_other && survey_.columns[k].numbers == 0) continue;
            if (is_other) {
                is_of_other_times =
                    is_time && time_ && !may_be_temperature(k) && survey_.columns[k].is_rising && !are_same_times(k);
                leave_out(k, Role::other_time, "is a time and no signal");
            } else if (is_of_other_times) {
                leave_out(k, Role::damaged, "has times of its own that differ from the first");
            }
        }
    }

    // without times each channel has the step that is said of it, as in LabVIEW's tables
    void leave_out_other_steps() {
        const std::vector<double>& steps = header_.spoken_steps;
        const auto first = std::find_if(steps.begin(), steps.end(), [](double step) { return step > 0.0; });
        if (time_ || hints_.is_rate_given || first == steps.end()) return;
        for (std::size_t k = 0; k < std::min(width(), steps.size()); ++k)
            if (is_channel(k) && steps[k] > 0.0 && steps[k] != *first)
                leave_out(
                    k, Role::damaged,
                    "has a step of " + base::shortest(steps[k]) + ", and the first has " + base::shortest(*first));
    }

    const std::string& named(std::size_t k) const { return header_.columns[k].name; }

    bool are_same_times(std::size_t k) const {
        const ColumnSurvey& a = survey_.columns[*time_];
        const ColumnSurvey& b = survey_.columns[k];
        const SignalColumn& a_column = header_.columns[*time_];
        const SignalColumn& b_column = header_.columns[k];
        const double a_unit = has_unit_of_time(a_column) ? unit_of_label(a_column.unit).value : 1.0;
        const double b_unit = has_unit_of_time(b_column) ? unit_of_label(b_column.unit).value : 1.0;
        const double step = (a.second - a.first) * a_unit;
        const double span = (a.last - a.first) * a_unit;
        double other = (b.last - b.first) * b_unit;
        // without a unit they may be in ms or ns
        const bool has_units = has_unit_of_time(a_column) && has_unit_of_time(b_column);
        if (!has_units && other > 0.0 && span > 0.0)
            other *= std::pow(1000.0, std::round(std::log10(span / other) / 3.0));
        return b.numbers == a.numbers && std::abs(other - span) <= 0.5 * step;
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
            } else if (const auto [marks, count] = marks_in(column); count > 0) {
                leave_out(k, Role::damaged,
                          "holds " + marks + " for no value, in " + std::to_string(count) + " of " +
                              std::to_string(rows) + " rows");
            }
        }
    }

    // what stands out so far is no value; if it comes again, less is enough
    static std::pair<std::string, std::uint64_t> marks_in(const ColumnSurvey& column) {
        std::pair<std::string, std::uint64_t> found;
        for (const auto& [mark, count] : column.marks) {
            const double beyond = count > 1 ? 3.0 : 20.0;
            if (!(std::abs(mark) > beyond * column.largest)) continue;
            found.first += (found.first.empty() ? "" : " and ") + base::shortest(mark);
            found.second += count;
        }
        if (found.second == column.numbers) return {};
        found.first += found.first.find(" and ") == std::string::npos ? ", a mark" : ", marks";
        return found;
    }

    // no sound grows by the same step from its first sample to its last, or by one
    bool is_counter(std::size_t k) const {
        const ColumnSurvey& column = survey_.columns[k];
        if (!has_no_unit(header_.columns[k]) || column.numbers <= 2) return false;
        const bool is_known = header_.has_names || hints_.is_rate_given || hints_.is_rate_said;
        return (column.is_even && column.is_rising && (has_whole_step(column) || is_known)) || counts_by_one(column);
    }

    // it may begin anew, skip some, or rest
    static bool counts_by_one(const ColumnSurvey& column) {
        const std::uint64_t steps = column.numbers - 1;
        const bool is_count = column.ups > 2 && column.ups + column.rests == steps;
        return column.is_whole && column.largest > 2.0 &&
               (is_count || 10 * std::max(column.ups, column.downs) > 9 * steps);
    }

    void leave_out_counters() {
        const auto is_signal = [&](std::size_t k) { return is_channel(k) && !is_counter(k); };
        std::size_t signals = 0;
        for (std::size_t k = 0; k < width(); ++k)
            signals += is_signal(k) ? 1U : 0U;
        for (std::size_t k = 0; k < width(); ++k)
            if (signals > 0 && is_channel(k) && is_counter(k))
                leave_out(k, Role::counter,
                          survey_.columns[k].is_even && survey_.columns[k].is_rising
                              ? "grows by the same step in every row, as a counter or a time does,"
                              : "counts by one, as no signal does,");
    }

    void check_wanted() const {
        for (std::size_t k = 0; k < width(); ++k) {
            const Role role = header_.columns[k].role;
            const bool is_wanted = !hints_.wanted.empty() && named(k) == hints_.wanted;
            if (!is_wanted || role == Role::channel) continue;
            if (survey_.columns[k].trouble)
                refuse_field(k, "Give every row a number, or cut the table to the rows that have one.");
            throw refusal({hints_.file, header_.names_number, 0, ""}, quoted(header_, k) + " is no channel",
                          role == Role::time ? "it has the times" : "it " + header_.columns[k].why);
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
        throw refusal({hints_.file, header_.data_number, 0, ""}, "the table has no column of samples", why,
                      why.find(" mark") == std::string::npos ? "" : "Cut the table to the rows without such marks.");
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
