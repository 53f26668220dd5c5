#include "stridor/io/structure/calculix.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/row_labels.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::refusal;
using reduction::RowLabel;

RowLabel label_in(const recordings::TextLine& line, const std::string& file) {
    FieldScanner scanner(line, file);
    const std::string_view word = scanner.word();
    // as text: as numbers 1000.1 and 1000.10 would be the same, and long node numbers would lose digits
    const std::size_t dot = word.rfind('.');
    const bool is_label =
        dot != std::string_view::npos && integer_in(word.substr(0, dot)).value_or(0) > 0 && word.size() == dot + 2;
    if (!is_label || word.back() < '0' || word.back() > '9')
        throw scanner.refusal(fmt::format("\"{}\" is no node.component", word), "each line labels a row: \"1000.3\"");
    if (word.back() < '1' || word.back() > '3')
        throw scanner.refusal(fmt::format("the component of {} is none of 1, 2 and 3", word),
                              "CalculiX stores displacements along x, y and z; 0 is a temperature");
    scanner.expect_end();
    return {std::string(word.substr(0, dot)), word.back() - '0'};
}

// what is wrong with a label that is there twice is not the label
void expect_solids(const std::vector<RowLabel>& labels, const std::string& file) {
    std::set<RowLabel> seen;
    for (const RowLabel& label : labels)
        if (!seen.insert(label).second)
            throw refusal(file, fmt::format("the label {} stands for several rows", reduction::describe(label)),
                          "CalculiX gives further rows the number of an old node: where it expands beams and shells to "
                          "solids, and for the inner modes of C3D8I",
                          "Use other solids (C3D8, C3D10, C3D20), or masses and springs.");
}

void expect_rows(const ListedMatrix& matrix, std::size_t labels, const std::string& label_file) {
    if (matrix.rows != static_cast<Eigen::Index>(labels))
        throw refusal(
            matrix.file,
            fmt::format("the {} has {} rows, {} has {} labels", name_of(matrix.role), matrix.rows, label_file, labels),
            "they must be of the same run", "Run CalculiX again; it writes all three.");
}

// what the deck says of the rows: rotations of rigid bodies, and nodes it does not have
void take_deck(reduction::ElasticPart& part, CalculixDeck deck, const std::string& label_file) {
    for (RowLabel& label : part.labels) {
        if (deck.rotation_nodes.contains(label.node))
            label.component += 3;
        else if (!deck.positions.empty() && !deck.positions.contains(label.node))
            throw refusal(label_file, fmt::format("node {} is not in the deck", label.node),
                          "CalculiX made it itself: for expanded elements, or for the rotations of a rigid body",
                          "Name a rigid body's rotations by ROT NODE=; use solids instead of beams and shells.");
    }
    part.positions = std::move(deck.positions);
    part.sets = std::move(deck.sets);
    part.notes.insert(part.notes.end(), deck.notes.begin(), deck.notes.end());
}

using recordings::TextLine;

constexpr int most_levels = 8;  // of includes
constexpr int most_includes = 256;
constexpr std::int64_t most_generated = 100'000'000;

/// "*NSET, NSET=FOOT, GENERATE" taken apart.
struct Keyword {
    std::string name;                           // "NSET", in capitals, blanks taken out
    std::map<std::string, std::string> values;  // "NSET" -> "FOOT"; the value as it is written
};

Keyword keyword_of(std::string_view line) {
    Keyword keyword;
    line.remove_prefix(1);
    bool is_name = true;
    for (std::size_t from = 0; from <= line.size();) {
        const std::size_t comma = std::min(line.find(',', from), line.size());
        const std::string_view piece = base::trimmed(line.substr(from, comma - from));
        const std::size_t equals = piece.find('=');
        std::string key = upper(piece.substr(0, equals));
        std::erase(key, ' ');
        if (is_name)
            keyword.name = key;
        else if (!key.empty())
            keyword.values[key] =
                equals == std::string_view::npos ? "" : std::string(base::trimmed(piece.substr(equals + 1)));
        is_name = false;
        from = comma + 1;
    }
    return keyword;
}

class DeckReader {
public:
    explicit DeckReader(const IncludeOpener& open_include) : open_include_(open_include) {}

    void read(const StructureInput& input, int level) {
        LineReader lines(input.bytes, input.name);
        while (const auto line = lines.next()) {
            const std::string_view text = base::trimmed(line->text);
            if (text.empty() || text.starts_with("**")) continue;
            if (text.starts_with('*')) {
                take_keyword(*line, input, level);
                continue;
            }
            FieldScanner scanner(*line, input.name);
            if (keyword_.name == "NODE") take_node(scanner, line->text);
            if (keyword_.name == "NSET") take_members(scanner);
            if (keyword_.name == "ELEMENT") take_element(scanner, text.ends_with(','));
            if (keyword_.name == "BOUNDARY") hold(scanner.word());
        }
    }

    CalculixDeck finish() {
        deck_.sets = sets_.take();
        return std::move(deck_);
    }

private:
    void take_keyword(const TextLine& line, const StructureInput& input, int level) {
        const FieldScanner scanner(line, input.name);
        keyword_ = keyword_of(base::trimmed(line.text));
        is_open_ = false;
        if (keyword_.name == "INCLUDE") return include(scanner, input, level);
        if (keyword_.name == "CONTACTPAIR")
            throw scanner.refusal("the model has a contact pair",
                                  "its springs would stand in the stiffness beside the contacts of Stridor",
                                  "Take it out, and name the nodes that touch to Stridor.");
        has_transform_ = has_transform_ || keyword_.name == "TRANSFORM";
        if (keyword_.name == "FREQUENCY" && upper(keyword_.values["GLOBAL"]) == "NO" && has_transform_)
            throw scanner.refusal("the matrices are in the systems of transformed nodes",
                                  "GLOBAL=NO stores them so; rows would not be along x, y and z",
                                  "Leave GLOBAL=NO out: GLOBAL=YES is the default.");
        if (keyword_.name == "RIGIDBODY" && keyword_.values.contains("ROTNODE"))
            deck_.rotation_nodes.insert(keyword_.values["ROTNODE"]);
        if (keyword_.name == "TIE" || keyword_.name == "EQUATION" || keyword_.name == "TRANSFORM" ||
            keyword_.name == "RIGIDBODY" || keyword_.name == "MPC")
            note(keyword_.name);
        if (keyword_.name == "NODE" && keyword_.values.contains("NSET")) begin_set(scanner);
        if (keyword_.name == "NSET") {
            if (keyword_.values["NSET"].empty())
                throw scanner.refusal("the node set has no name", "*NSET needs NSET=NAME");
            begin_set(scanner);
        }
    }

    void note(const std::string& name) {
        const std::string sentence = fmt::format("the deck holds *{}: rows that depend on others are absent",
                                                 name == "RIGIDBODY" ? std::string("RIGID BODY") : name);
        if (std::find(deck_.notes.begin(), deck_.notes.end(), sentence) == deck_.notes.end())
            deck_.notes.push_back(sentence);
    }

    void include(const FieldScanner& scanner, const StructureInput& input, int level) {
        std::string name = keyword_.values["INPUT"];
        if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
        if (name.empty()) throw scanner.refusal("*INCLUDE names no file", "it needs INPUT=FILE");
        if (level + 1 >= most_levels || ++includes_ > most_includes)
            throw scanner.refusal("the includes do not end", "they stand in each other, or are too many");
        const auto included = open_include_ ? open_include_(name, input.name) : std::nullopt;
        if (!included)
            throw scanner.refusal(fmt::format("the included file \"{}\" is not there", name), "",
                                  "Put it beside the deck?");
        keyword_ = {};
        read(*included, level + 1);
        keyword_ = {};
    }

    void begin_set(const FieldScanner& scanner) {
        const std::string& name = keyword_.values["NSET"];
        current_ = sets_.place_of(upper(name), name);
        expect_room(scanner, 0);
    }

    // for so many more nodes in sets
    void expect_room(const FieldScanner& scanner, std::size_t nodes) const {
        if (const auto problem = sets_.excess(nodes))
            throw scanner.refusal(problem->what, problem->why, problem->suggestion);
    }

    void take_node(FieldScanner& scanner, std::string_view line) {
        const std::string node = std::to_string(scanner.integer("a node"));
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
        std::string_view rest = line;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const std::size_t comma = rest.find(',');
            if (comma == std::string_view::npos) break;  // what is left out is zero
            rest.remove_prefix(comma + 1);
            const std::string_view field = base::trimmed(rest.substr(0, rest.find(',')));
            const auto value = field.empty() ? std::optional(0.0) : real_in(field);
            if (!value) throw scanner.refusal(fmt::format("\"{}\" is no coordinate", field));
            position[axis] = *value;
        }
        deck_.positions[node] = position;
        if (keyword_.values.contains("NSET")) add_member(scanner, node);
    }

    // a line that ends with a comma goes on in the next
    void take_element(FieldScanner& scanner, bool goes_on) {
        if (!is_open_) {
            scanner.word();  // its number
            deck_.elements.push_back({upper(keyword_.values["TYPE"]), {}});
        }
        for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
            deck_.elements.back().nodes.emplace_back(word);
        is_open_ = goes_on;
    }

    void hold(std::string_view name) {
        if (const std::optional<std::size_t> set = sets_.find(upper(name)))
            deck_.held.insert(sets_.nodes_of(*set).begin(), sets_.nodes_of(*set).end());
        else
            deck_.held.emplace(name);
    }

    void add_member(const FieldScanner& scanner, std::string node) {
        expect_room(scanner, 1);
        sets_.add(current_, std::move(node));
    }

    void take_members(FieldScanner& scanner) {
        if (keyword_.values.contains("GENERATE")) return generate(scanner);
        for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
            if (const auto node = integer_in(word)) {
                add_member(scanner, std::to_string(*node));
                continue;
            }
            const std::optional<std::size_t> other = sets_.find(upper(word));
            if (!other) throw scanner.refusal(fmt::format("there is no node set \"{}\"", word));
            if (*other == current_) throw scanner.refusal(fmt::format("the node set {} holds itself", word));
            expect_room(scanner, sets_.nodes_of(*other).size());
            for (const std::string& node : sets_.nodes_of(*other))
                sets_.add(current_, node);
        }
    }

    void generate(FieldScanner& scanner) {
        const std::int64_t first = scanner.integer("the first node");
        const std::int64_t last = scanner.integer("the last node");
        const std::string_view word = scanner.word();
        const std::int64_t step = word.empty() ? 1 : integer_in(word).value_or(0);
        if (first < 1 || last < first || last > most_generated || step < 1)
            throw scanner.refusal("these nodes cannot be counted", "GENERATE needs first, last and step, rising");
        expect_room(scanner, static_cast<std::size_t>((last - first) / step + 1));
        for (std::int64_t node = first; node <= last; node += step)
            sets_.add(current_, std::to_string(node));
    }

    const IncludeOpener& open_include_;
    CalculixDeck deck_;
    Keyword keyword_;
    SetTable sets_;            // by their names in capitals
    std::size_t current_ = 0;  // place of the set that is filled
    int includes_ = 0;
    bool has_transform_ = false;
    bool is_open_ = false;  // the last element
};

}  // namespace

std::vector<RowLabel> read_calculix_labels(const StructureInput& input) {
    LineReader lines(input.bytes, input.name);
    std::vector<RowLabel> labels;
    while (const auto line = lines.next())
        if (line->text.find_first_not_of(" \t") != std::string_view::npos)
            labels.push_back(label_in(*line, input.name));
    if (labels.empty()) throw refusal(input.name, "there is no label in it", "each line labels a row: \"1000.3\"");
    expect_solids(labels, input.name);
    return labels;
}

ListedMatrix read_calculix_matrix(const StructureInput& input, MatrixRole role) {
    LineReader lines(input.bytes, input.name);
    ListedMatrix matrix{.file = input.name, .role = role};
    while (const auto line = lines.next()) {
        if (line->text.find_first_not_of(" \t") == std::string_view::npos) continue;
        FieldScanner scanner(*line, input.name);
        const std::int64_t row = scanner.integer("a row");
        const std::int64_t column = scanner.integer("a column");
        add_entry(matrix, scanner, row, column, scanner.real("a value"));
        scanner.expect_end();
    }
    if (matrix.entries.empty())
        throw refusal(input.name, "there is no entry in it", "each line holds row, column and value");
    return matrix;
}

reduction::ElasticPart read_calculix(const CalculixFiles& files) {
    const std::vector<RowLabel> labels = read_calculix_labels(files.labels);
    ListedMatrix stiffness = read_calculix_matrix(files.stiffness, MatrixRole::stiffness);
    ListedMatrix mass = read_calculix_matrix(files.mass, MatrixRole::mass);
    expect_rows(stiffness, labels.size(), files.labels.name);
    expect_rows(mass, labels.size(), files.labels.name);
    stiffness.labels = mass.labels = labels;
    reduction::ElasticPart part = joined_part(std::move(stiffness), mass, nullptr);
    if (files.deck)
        take_deck(part, read_calculix_deck(*files.deck, files.open_include), files.labels.name);
    else
        part.notes.emplace_back("without its deck (.inp) the part has neither places nor sets of nodes");
    return part;
}

CalculixDeck read_calculix_deck(const StructureInput& input, const IncludeOpener& open_include) {
    DeckReader reader(open_include);
    reader.read(input, 0);
    return reader.finish();
}

}  // namespace stridor::io::structure
