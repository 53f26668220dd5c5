#include "stridor/recordings/mat/mat_choice.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/signal_csv_header.hpp"
#include "stridor/recordings/table/table_start.hpp"
#include "stridor/recordings/time_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::recordings::mat {

namespace {

constexpr std::size_t most_channels = 256;
constexpr std::size_t most_listed = 8;
constexpr const char* rate_help = "Give it (--rate 48000), or save it there: fs = 48000.";

constexpr std::array<std::string_view, 17> rate_names{"fs",
                                                      "fsamp",
                                                      "fsample",
                                                      "fsampling",
                                                      "f_s",
                                                      "f_sample",
                                                      "sr",
                                                      "srate",
                                                      "rate",
                                                      "samplerate",
                                                      "sample_rate",
                                                      "samplingrate",
                                                      "sampling_rate",
                                                      "samplefrequency",
                                                      "sample_frequency",
                                                      "samplingfrequency",
                                                      "sampling_frequency"};
constexpr std::array<std::string_view, 8> step_names{
    "dt", "delta_t", "deltat", "ts", "sample_time", "sampletime", "sampleinterval", "sampling_interval"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, std::string name) {
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    return std::find(names.begin(), names.end(), name) != names.end();
}

// "time" of "s.time": a field of a structure
std::string field_of(const std::string& name) {
    return name.substr(name.rfind('.') + 1);
}

// Simulink calls its times tout
bool is_time_variable(const std::string& path) {
    const std::string name = field_of(path);
    return csv_table::is_time_name(name) || name == "tout" || name == "Time_s" || name == "time_s";
}

bool holds_numbers(const Variable& variable) {
    return variable.kind == MatKind::doubles || variable.kind == MatKind::singles || variable.kind == MatKind::integers;
}

bool is_single(const Variable& variable) {
    return variable.rows == 1 && variable.columns == 1;
}

bool is_vector(const Variable& variable) {
    return std::min(variable.rows, variable.columns) == 1;
}

std::uint64_t length(const Variable& variable) {
    return std::max(variable.rows, variable.columns);
}

std::string_view words_of(MatKind kind) {
    constexpr std::array<std::string_view, static_cast<std::size_t>(MatKind::count)> words{
        "numbers",         "numbers",  "whole numbers", "truth values", "complex numbers",
        "a sparse matrix", "text",     "cells",         "a structure",  "more than two dimensions",
        "nothing in it",   "an object"};
    return words.at(static_cast<std::size_t>(kind));
}

std::string description(const Variable& variable) {
    const std::string size = std::to_string(variable.rows) + " x " + std::to_string(variable.columns);
    return variable.name + " (" + (holds_numbers(variable) ? size : std::string(words_of(variable.kind))) + ")";
}

std::string listing(const std::vector<Variable>& variables, const std::vector<std::size_t>& which) {
    std::string text;
    for (std::size_t k = 0; k < which.size(); ++k) {
        if (k == most_listed) return text + ", ...";
        text += (k > 0 ? ", " : "") + description(variables[which[k]]);
    }
    return text;
}

bool is_rate(double rate) {
    return std::isfinite(rate) && rate > 0.0 && rate <= signal_table::highest_rate;
}

/// Works through the variables once.
class Chooser {
public:
    Chooser(const std::vector<Variable>& variables, const Wishes& wishes, const std::string& file)
        : variables_(variables),
          wishes_(wishes),
          file_(file) {
        for (std::size_t k = 0; k < variables.size(); ++k) {
            const bool is_number = holds_numbers(variables[k]);
            if (is_number && !is_single(variables[k])) candidates_.push_back(k);
            if (!is_number) left_out_.push_back(k);
        }
    }

    MatChoice choice() {
        read_single_numbers();
        if (candidates_.empty())
            throw refusal(file_, "the file holds no signal",
                          variables_.empty()
                              ? "it has no variables that can be read"
                              : "no variable is a vector or a matrix of real numbers: " + listing_of_all(),
                          left_out_.empty() ? "" : "Save the numbers as variables of their own: force = s.Data.");
        find_times();
        choose_length();
        leave_out_times();
        take_first_column_as_time();
        add_channels();
        if (!left_out_.empty()) choice_.notes.push_back("left out: " + listing(variables_, left_out_));
        for (const std::size_t k : left_out_)
            choice_.left_out.push_back(description(variables_[k]));
        return std::move(choice_);
    }

private:
    std::string listing_of_all() const {
        std::vector<std::size_t> all(variables_.size());
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k] = k;
        return listing(variables_, all);
    }

    void take_rate(double rate, const Variable& from) {
        if (!is_rate(rate))
            throw refusal(file_, from.name + " = " + base::shortest(from.value) + " gives no sampling rate", "",
                          wishes_.rate ? "" : "Give the rate: --rate 48000.");
        const bool agrees = !choice_.rate || std::abs(*choice_.rate / rate - 1.0) < 1e-9;
        if (!agrees)
            throw refusal(file_, "the file tells two sampling rates",
                          base::shortest(*choice_.rate) + " Hz, and " + base::shortest(rate) + " Hz by " + from.name,
                          "Say which one it is: --rate " + base::shortest(*choice_.rate) + ".");
        choice_.rate = rate;
    }

    void read_single_numbers() {
        choice_.rate = std::nullopt;
        std::vector<const Variable*> steps;
        for (const Variable& variable : variables_) {
            if (!holds_numbers(variable) || !is_single(variable)) continue;
            if (is_one_of(rate_names, field_of(variable.name))) {
                if (!wishes_.rate) take_rate(variable.value, variable);
            } else if (is_one_of(step_names, field_of(variable.name))) {
                steps.push_back(&variable);
            } else {
                choice_.metadata.emplace_back(variable.name, base::shortest(variable.value));
            }
        }
        // a step is one over a rate that has fewer digits
        for (const Variable* step : steps)
            if (!choice_.rate && !wishes_.rate)
                take_rate(step->value > 0.0 ? snapped_rate(step->value, 1e-12).rate : 0.0, *step);
        if (wishes_.rate) choice_.rate = wishes_.rate;
    }

    // the times that fit the wish, if there are any
    void find_times() {
        const std::optional<std::size_t> wished = wished_variable();
        for (const std::size_t k : candidates_) {
            const Variable& variable = variables_[k];
            const bool fits = !wished || (*wished != k && fits_length(variables_[*wished], length(variable)));
            if (choice_.time || !is_vector(variable) || !is_time_variable(variable.name) || !fits) continue;
            choice_.time = MatColumn{k, 0, variable.rows == 1 ? 1U : 0U};
            choice_.time_name = variable.name;
            choice_.has_single_times = variable.kind == MatKind::singles;
            choice_.frames = length(variable);
        }
        if (!choice_.time) return;
        std::erase(candidates_, choice_.time->variable);
        // what else is a time is no signal
        const auto is_other = [&](std::size_t k) {
            return wished != k && is_vector(variables_[k]) && is_time_variable(variables_[k].name);
        };
        keep_only([&](std::size_t k) { return !is_other(k); });
    }

    static bool fits_length(const Variable& variable, std::uint64_t frames) {
        return variable.rows == frames || variable.columns == frames;
    }

    // "data" and "data(2)" are both of the variable data
    std::optional<std::size_t> wished_variable() const {
        const std::string& name = wishes_.channel;
        for (const std::size_t k : candidates_)
            if (name == variables_[k].name || name.starts_with(variables_[k].name + "(")) return k;
        return std::nullopt;
    }

    void keep_only(const auto& is_kept) {
        for (const std::size_t k : candidates_)
            if (!is_kept(k)) left_out_.push_back(k);
        std::erase_if(candidates_, [&](std::size_t k) { return !is_kept(k); });
        std::sort(left_out_.begin(), left_out_.end());
    }

    void choose_length() {
        if (choice_.time) {
            keep_only([&](std::size_t k) { return fits_length(variables_[k], choice_.frames); });
            if (candidates_.empty())
                throw refusal(file_, "no variable is as long as the times",
                              choice_.time_name + " has " + std::to_string(choice_.frames) + " numbers" +
                                  (left_out_.empty() ? "" : "; there are " + listing(variables_, left_out_)),
                              "Save the numbers as variables of their own: force = s.Data.");
            return;
        }
        const auto is_as_long = [&](std::size_t k) { return length(variables_[k]) == choice_.frames; };
        choice_.frames = length(variables_[candidates_.front()]);
        if (std::all_of(candidates_.begin(), candidates_.end(), is_as_long)) return;
        const std::optional<std::size_t> wished = wished_variable();
        if (!wished)
            throw refusal(file_, "the variables differ in length", listing(variables_, candidates_),
                          "Choose one by its name: --channel NAME; a column of a matrix is NAME(1).");
        choice_.frames = length(variables_[*wished]);
        keep_only([&](std::size_t k) { return k == *wished; });
    }

    // the user's rate outranks them: they may be uneven
    void leave_out_times() {
        if (!wishes_.rate || !choice_.time) return;
        choice_.notes.push_back("the times in " + choice_.time_name + " were left out, as --rate tells " +
                                base::shortest(*wishes_.rate) + " Hz");
        choice_.left_out.push_back(choice_.time_name + " (times)");
        choice_.time.reset();
        choice_.time_name.clear();
    }

    // as in a table without names
    void take_first_column_as_time() {
        if (choice_.time || choice_.rate) return;
        const Variable& only = variables_[candidates_.front()];
        if (candidates_.size() > 1 || is_vector(only))
            throw refusal(file_, "the file does not tell its sampling rate",
                          "it has no single number called fs or dt, and no vector called t or time", rate_help);
        choice_.time = MatColumn{candidates_.front(), 0, only.rows < only.columns ? 1U : 0U};
        choice_.time_name = only.name + "(1)";
        choice_.is_time_guessed = true;
        choice_.has_single_times = only.kind == MatKind::singles;
        choice_.notes.push_back(choice_.time_name + " was taken for the time in seconds");
    }

    void add_channels() {
        for (const std::size_t k : candidates_) {
            const Variable& variable = variables_[k];
            const bool is_flat = variable.rows != choice_.frames;
            const std::uint64_t width = is_flat ? variable.rows : variable.columns;
            for (std::uint64_t index = 0; index < width && choice_.columns.size() <= most_channels; ++index) {
                const MatColumn column{k, index, is_flat ? 1U : 0U};
                if (choice_.time == column) continue;
                const std::string suffix = width > 1 ? "(" + std::to_string(index + 1) + ")" : "";
                choice_.columns.push_back(column);
                choice_.channels.push_back({variable.name + suffix, ""});
            }
        }
        if (choice_.columns.size() > most_channels)
            throw refusal(file_, "the file holds more than " + std::to_string(most_channels) + " channels",
                          listing(variables_, candidates_), "Save fewer of them.");
    }

    const std::vector<Variable>& variables_;
    const Wishes& wishes_;
    const std::string& file_;
    std::vector<std::size_t> candidates_;  // vectors and matrices of numbers
    std::vector<std::size_t> left_out_;
    MatChoice choice_;
};

}  // namespace

MatChoice choose(const std::vector<Variable>& variables, const Wishes& wishes, const std::string& file) {
    return Chooser(variables, wishes, file).choice();
}

}  // namespace stridor::recordings::mat
