#include "stridor/io/library/library_texts.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/io/library/json_entry.hpp"
#include "stridor/noise_library/field.hpp"

#include <utility>

namespace stridor::io {

namespace {

using base::Json;
using noise_library::Bin;
using noise_library::CategoryCount;
using noise_library::CategoryRange;
using noise_library::Entry;
using noise_library::Figure;
using noise_library::Observation;
using noise_library::RankCorrelation;
using noise_library::Sensitivity;

Json opening_of(std::string_view what, const std::filesystem::path& library) {
    Json document = json_parts::opening(what);
    document["library"] = library.string();
    return document;
}

Json figures_object(std::span<const Figure> figures) {
    Json object = Json::object();
    for (const Figure& figure : figures)
        object[figure.name] = figure.value;
    return object;
}

// the verdict as the object it is; as text should it be none
Json verdict_of(const std::string& text) {
    Json verdict = base::foreign_document(text);
    return verdict.is_discarded() ? Json(text) : verdict;
}

// a document as a part of another: its lines moved to the right
std::string moved(const std::string& text, std::size_t columns) {
    std::string result;
    for (const char c : text) {
        result += c;
        if (c == '\n') result.append(columns, ' ');
    }
    return result;
}

Json correlation_object(const RankCorrelation& correlation) {
    return {{"records", correlation.records}, {"spearman", correlation.coefficient}, {"p_value", correlation.p_value}};
}

Json counts_object(std::span<const CategoryCount> counts) {
    Json object = Json::object();
    for (const CategoryCount& count : counts)
        object[count.category.empty() ? "unknown" : count.category] = count.records;
    return object;
}

Json records_array(const Sensitivity& sensitivity) {
    return json_parts::array_of(sensitivity.records, [&](const Observation& record) -> Json {
        return {{"id", record.id},
                {sensitivity.quantity, record.quantity},
                {"category", base::text_or_null(record.category)},
                {"level", record.level},
                {"dominant_frequency", record.frequency}};
    });
}

}  // namespace

using base::csv_text::Table;
using base::csv_text::TableColumn;

std::string library_csv(std::span<const Entry> entries) {
    std::map<std::string, std::string> figures;  // name -> unit
    for (const Entry& entry : entries)
        for (const noise_library::Figure& figure : entry.figures)
            figures.emplace(figure.name, figure.unit);
    std::vector<TableColumn> columns{{"id"}};
    for (const noise_library::EntryField& field : noise_library::fields()) {
        const std::string_view unit = noise_library::unit_of(field);
        if (!noise_library::is_document(field)) columns.push_back({std::string(field.name), std::string(unit)});
    }
    for (const auto& [name, unit] : figures)
        columns.push_back({name, unit});

    Table table(base::csv_text::origin("library"), columns);
    for (const Entry& entry : entries) {
        table.number(static_cast<double>(entry.id));
        for (const noise_library::EntryField& field : noise_library::fields()) {
            if (noise_library::is_document(field)) continue;
            if (std::holds_alternative<noise_library::EntryQuantity>(field.kind))
                table.number(noise_library::quantity_in(entry, field));
            else
                table.word(noise_library::words_in(entry, field));
        }
        for (const auto& [name, unit] : figures)
            table.number(noise_library::number_of(entry, name));
        table.end_row();
    }
    return table.take();
}

std::string LibraryJson::opening(const std::filesystem::path& library) {
    std::string text = base::text_of(opening_of("library", library));
    text.erase(text.find_last_not_of("\n}") + 1);
    return text + ",\n  \"entries\": [";
}

std::string LibraryJson::entry(const Entry& entry) {
    Json object = json_parts::entry_object(entry);
    if (!entry.verdict.empty()) object["verdict"] = verdict_of(entry.verdict);
    object["figures"] = figures_object(entry.figures);
    for (const Figure& figure : entry.figures)
        units_["figures." + figure.name] = figure.unit;
    return (std::exchange(is_first_, false) ? "\n    " : ",\n    ") + moved(base::text_of(object), 4);
}

std::string LibraryJson::closing(std::string_view more) const {
    Json units = Json::object();
    for (const noise_library::EntryField& field : noise_library::fields())
        if (const std::string_view unit = noise_library::unit_of(field); !unit.empty())
            units[std::string(field.name)] = unit;
    for (const auto& [name, unit] : units_)
        units[name] = unit;
    return std::string(is_first_ ? "]" : "\n  ]") + ",\n  \"units\": " + moved(base::text_of(units), 2) +
           std::string(more) + "\n}";
}

namespace {

std::string document_of(const std::filesystem::path& library, std::span<const Entry> entries, std::string_view more) {
    LibraryJson document;
    std::string text = document.opening(library);
    for (const Entry& entry : entries)
        text += document.entry(entry);
    return text + document.closing(more);
}

}  // namespace

std::string library_json(const std::filesystem::path& library, std::span<const Entry> entries) {
    return document_of(library, entries, "");
}

std::string arrivals_json(const std::filesystem::path& library, std::span<const Entry> entries,
                          const noise_library::Arrivals& arrivals) {
    Json summary{{"added", arrivals.added}, {"passed_over", arrivals.passed_over}, {"left", arrivals.left}};
    summary["known"] = Json::array();
    for (const noise_library::KnownRecording& known : arrivals.known)
        summary["known"].push_back({{"file", known.file}, {"id", known.id}});
    summary["refused"] = Json::array();
    for (const recordings::RefusedRecording& refused : arrivals.refused)
        summary["refused"].push_back({{"file", refused.file}, {"reason", refused.reason}});
    return document_of(library, entries, ",\n  \"summary\": " + moved(base::text_of(summary), 2));
}

std::string sensitivity_json(const std::filesystem::path& library, const Sensitivity& sensitivity) {
    Json document = opening_of("sensitivity", library);
    document["over"] = sensitivity.quantity;
    document["left_out"] = sensitivity.left_out;
    document["level"] = correlation_object(sensitivity.level);
    document["dominant_frequency"] = correlation_object(sensitivity.frequency);
    Json categories = Json::array();
    for (const CategoryRange& range : sensitivity.categories)
        categories.push_back({{"category", base::text_or_null(range.category)},
                              {"records", range.records},
                              {"lowest", range.lowest},
                              {"median", range.median},
                              {"highest", range.highest}});
    document["categories"] = std::move(categories);
    Json bins = Json::array();
    for (const Bin& bin : sensitivity.bins)
        bins.push_back({{"from", bin.from},
                        {"to", bin.to},
                        {"records", bin.records},
                        {"categories", counts_object(bin.categories)},
                        {"level", bin.level},
                        {"dominant_frequency", bin.frequency}});
    document["bins"] = std::move(bins);
    document["records"] = records_array(sensitivity);
    document["units"] = {
        {sensitivity.quantity, sensitivity.unit}, {"level", sensitivity.level_unit}, {"dominant_frequency", "Hz"}};
    return base::text_of(document);
}

void library_json(noise_library::Library& library, const noise_library::Query& query,
                  const std::function<void(std::string_view)>& take) {
    constexpr std::size_t least_piece = std::size_t{1} << 16U;
    LibraryJson document;
    std::string text = document.opening(library.file());
    library.visit(query, [&](const noise_library::Entry& entry) {
        text += document.entry(entry);
        if (text.size() < least_piece) return;
        take(text);
        text.clear();
    });
    take(text + document.closing() + "\n");
}

}  // namespace stridor::io
