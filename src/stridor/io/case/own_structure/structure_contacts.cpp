#include "stridor/io/case/own_structure/structure_contacts.hpp"

#include "stridor/io/structure/row_labels.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::io {

namespace {

namespace csv = recordings::csv_table;
using parameters::OwnContact;
using parameters::OwnOutput;
using recordings::refusal;
using reduction::ElasticPart;

// [1] cosine up to which a tangent is at right angles: directions are written with some digits
constexpr double right_angle = 1e-3;

std::vector<std::string> written_words(std::string_view text) {
    std::vector<std::string> words;
    for (const std::string_view word : recordings::words(text))
        words.emplace_back(word);
    return words;
}

std::optional<std::vector<double>> written_numbers(const std::vector<std::string>& words) {
    std::vector<double> numbers;
    for (const std::string& word : words) {
        const auto number = csv::number_in(word, csv::Dialect{';'});
        if (!number || !std::isfinite(*number)) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers.empty() ? std::nullopt : std::optional(numbers);
}

// "-y2" taken apart
std::pair<double, std::string> signed_name(const std::string& word) {
    if (word.size() > 1 && (word[0] == '-' || word[0] == '+')) return {word[0] == '-' ? -1.0 : 1.0, word.substr(1)};
    return {1.0, word};
}

// does none of them follow from the others? By what is left of each beside those before it
bool are_independent(const std::vector<std::vector<double>>& directions) {
    constexpr double left = 1e-6;  // [1] of its length
    std::vector<Eigen::VectorXd> before;
    for (const std::vector<double>& direction : directions) {
        Eigen::VectorXd rest = Eigen::Map<const Eigen::VectorXd>(direction.data(), std::ssize(direction));
        rest.normalize();
        for (const Eigen::VectorXd& other : before)
            rest -= other.dot(rest) * other;
        if (!(rest.norm() > left)) return false;
        before.push_back(rest.normalized());
    }
    return true;
}

/// Makes the rows of one contact after the other.
class ContactMaker {
public:
    explicit ContactMaker(const ElasticPart& part) : part_(part) {}

    /// The contacts of what one entry says.
    void take(const NamedContact& named) {
        place_ = named.place;
        if (!named.node.empty() && !named.set.empty())
            throw problem("the contact has a node and a set", "each node of a set has a contact of its own");
        if (!named.set.empty()) return take_set(named);
        const std::string& name = named.said.name;
        if (!named.node.empty()) return take_node(named, named.node, name.empty() ? named.node : name, 1);
        if (!named.against.empty()) throw problem("the contact is against a part, and at no node", "");
        if (name.empty()) throw problem("this contact has no name", "one that is not at a node is called by it");
        OwnContact contact = named.said;
        if (named.has("second_tangent"))
            contact.second_tangent = of_rows(named.directions.at("second_tangent"), "second tangent");
        contact.normal = of_rows(named.directions.at("normal"), "normal");
        contact.tangent = of_rows(named.directions.at("tangent"), "tangent");
        add(named, std::move(contact));
    }

    std::vector<OwnContact> finish() { return std::move(contacts_); }

    /// The rows of an output.
    std::vector<double> output_rows(const NamedOutput& named) {
        place_ = named.place;
        if (named.node.empty()) return of_rows(named.direction, "direction");
        std::vector<double> rows(part_.labels.size(), 0.0);
        put(rows, named.node, in_space(named.direction, "direction"), 1.0);
        return rows;
    }

private:
    Error problem(std::string what, std::string why, std::string suggestion = "") const {
        return refusal(place_, std::move(what), std::move(why), std::move(suggestion));
    }

    // an error of the part, told where the contact stands
    template <typename Work>
    auto at_place(const Work& work) const {
        try {
            return work();
        } catch (const Error& error) {
            throw Error(error.kind(), error.problem(), place_);
        }
    }

    const reduction::NodeSet& set_named(const std::string& name) const {
        const reduction::NodeSet* set = find_set(part_, name);
        if (set == nullptr)
            throw problem(fmt::format("there is no node set \"{}\"", name),
                          part_.sets.empty() ? "the structure has none" : "its node sets are " + set_names(part_));
        if (set->nodes.empty()) throw problem(fmt::format("the node set {} is empty", name), "");
        return *set;
    }

    // in the order in which they stand along the longest side of the box around them, where places are known
    std::vector<std::string> along_line(std::vector<std::string> nodes) const {
        const bool is_known = std::all_of(nodes.begin(), nodes.end(),
                                          [&](const std::string& node) { return part_.positions.contains(node); });
        if (!is_known) return nodes;
        Eigen::Vector3d least = part_.positions.at(nodes.front());
        Eigen::Vector3d most = least;
        for (const std::string& node : nodes) {
            least = least.cwiseMin(part_.positions.at(node));
            most = most.cwiseMax(part_.positions.at(node));
        }
        Eigen::Index axis = 0;
        (most - least).maxCoeff(&axis);
        std::stable_sort(nodes.begin(), nodes.end(), [&](const std::string& a, const std::string& b) {
            return part_.positions.at(a)[axis] < part_.positions.at(b)[axis];
        });
        return nodes;
    }

    void take_set(const NamedContact& named) {
        const std::vector<std::string> nodes = along_line(set_named(named.set).nodes);
        const std::string opening = named.said.name.empty() ? "" : named.said.name + " ";
        for (const std::string& node : nodes)
            take_node(named, node, opening + node, nodes.size());
    }

    void take_node(const NamedContact& named, const std::string& node, const std::string& name, std::size_t among) {
        const Eigen::Vector3d normal = in_space(named.directions.at("normal"), "normal");
        const Eigen::Vector3d tangent = in_space(named.directions.at("tangent"), "tangent");
        if (std::abs(normal.dot(tangent)) > right_angle)
            throw problem("normal and tangent are not at right angles",
                          fmt::format("their cosine is {:.3g}", normal.dot(tangent)));
        // what is left of the written digits
        const Eigen::Vector3d along = (tangent - normal.dot(tangent) * normal).normalized();
        const std::string other = other_node(named, node);
        const auto rows_along = [&](const Eigen::Vector3d& direction) {
            std::vector<double> rows(part_.labels.size(), 0.0);
            put(rows, node, direction, 1.0);
            if (!other.empty()) put(rows, other, direction, -1.0);
            return rows;
        };
        OwnContact contact = named.said;
        contact.name = name;
        contact.normal = rows_along(normal);
        contact.tangent = rows_along(along);
        if (named.has("second_tangent"))
            contact.second_tangent = rows_along(second_direction(named.directions.at("second_tangent"), normal, along));
        contact.preload_share /= static_cast<double>(among);
        if (const auto found = part_.positions.find(node); found != part_.positions.end())
            contact.position = {found->second.x(), found->second.y(), found->second.z()};
        add(named, std::move(contact));
    }

    // the one at right angles to both; what is written says which way it goes
    Eigen::Vector3d second_direction(const NamedDirection& written, const Eigen::Vector3d& normal,
                                     const Eigen::Vector3d& along) const {
        const Eigen::Vector3d given = in_space(written, "second tangent");
        const Eigen::Vector3d right = normal.cross(along);
        const double cosine = right.dot(given);
        if (std::abs(given.dot(normal)) > right_angle || std::abs(given.dot(along)) > right_angle)
            throw problem("the second tangent is not at right angles to normal and tangent",
                          fmt::format("their cosines are {:.3g} and {:.3g}", given.dot(normal), given.dot(along)));
        return cosine < 0.0 ? Eigen::Vector3d(-right) : right;
    }

    const Eigen::Vector3d& position(const std::string& node) const {
        const auto found = part_.positions.find(node);
        if (found == part_.positions.end())
            throw problem(fmt::format("the place of node {} is not known", node),
                          "the nearest node of a set is told by places", "Name one node in against.");
        return found->second;
    }

    std::string other_node(const NamedContact& named, const std::string& node) const {
        if (named.against.empty() || find_set(part_, named.against) == nullptr) return named.against;
        const Eigen::Vector3d& here = position(node);
        std::string nearest;
        double least = std::numeric_limits<double>::infinity();
        for (const std::string& other : set_named(named.against).nodes) {
            const double distance = (position(other) - here).squaredNorm();
            if (distance < least && other != node) {
                least = distance;
                nearest = other;
            }
        }
        return nearest;
    }

    Eigen::Vector3d in_space(const NamedDirection& direction, std::string_view what) const {
        Eigen::Vector3d vector = Eigen::Vector3d::Zero();
        const auto* text = std::get_if<std::string>(&direction);
        const std::vector<std::string> words = text == nullptr ? std::vector<std::string>() : written_words(*text);
        const auto numbers = text == nullptr ? std::get<std::vector<double>>(direction)
                                             : written_numbers(words).value_or(std::vector<double>());
        if (text != nullptr && numbers.empty()) {
            const auto [sign, name] = signed_name(words.size() == 1 ? words.front() : std::string());
            const std::optional<int> component = structure::component_in(name);
            if (!component || *component < 1 || *component > 3)
                throw problem(fmt::format("\"{}\" is no direction of a {}", *text, what),
                              "at a node it is x, y or z with a sign, or three numbers");
            vector[*component - 1] = sign;
            return vector;
        }
        if (numbers.size() != 3)
            throw problem(fmt::format("the {} has {} components", what, numbers.size()),
                          "at a node there are three, along x, y and z");
        vector << numbers[0], numbers[1], numbers[2];
        if (!(vector.norm() > 0.0)) throw problem(fmt::format("the {} is zero", what), "it has no direction");
        return vector / vector.norm();
    }

    void put(std::vector<double>& rows, const std::string& node, const Eigen::Vector3d& direction, double sign) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (direction[axis] == 0.0) continue;
            const auto found = at_place([&] { return named_rows(part_, fmt::format("{}:{}", node, axis + 1)); });
            rows[static_cast<std::size_t>(found.front())] += sign * direction[axis];
        }
    }

    std::vector<double> of_rows(const NamedDirection& direction, std::string_view what) const {
        std::vector<double> rows(part_.labels.size(), 0.0);
        const auto* text = std::get_if<std::string>(&direction);
        const std::vector<std::string> words = text == nullptr ? std::vector<std::string>() : written_words(*text);
        // as many numbers as rows are a component each, in a table of contacts too
        std::optional<std::vector<double>> numbers;
        if (text == nullptr)
            numbers = std::get<std::vector<double>>(direction);
        else if (words.size() == rows.size() && rows.size() > 1)
            numbers = written_numbers(words);
        if (numbers && numbers->size() != rows.size())
            throw problem(fmt::format("the {} has {} components", what, numbers->size()),
                          fmt::format("the structure has {} rows, and the contact no node", rows.size()));
        if (numbers) rows = *numbers;
        for (std::size_t k = 0; !numbers && k < words.size(); ++k) {
            const auto [sign, name] = signed_name(words[k]);
            const auto found = at_place([&, row = name] { return named_rows(part_, row); });
            if (found.size() != 1)
                throw problem(fmt::format("\"{}\" is {} rows", name, found.size()),
                              "a direction is made of single rows", "Name a node and its directions instead.");
            rows[static_cast<std::size_t>(found.front())] += sign;
        }
        if (std::all_of(rows.begin(), rows.end(), [](double value) { return value == 0.0; }))
            throw problem(fmt::format("the {} is zero", what), "it has no direction");
        return rows;
    }

    void add(const NamedContact& named, OwnContact contact) {
        for (const parameters::ContactField& field : parameters::contact_fields())
            if (!field.only_beside.empty() && !named.has(field.only_beside) && !is_usual(contact, field))
                throw problem(fmt::format("{} stands without a {}", field.key, field.only_beside),
                              "the contact slips in one direction");
        const std::string& name = contact.name;
        if (!are_independent({contact.normal, contact.tangent}))
            throw problem(fmt::format("the tangent of contact \"{}\" is along its normal", name),
                          "what opens the gap would be slip", "Give it a tangent at right angles to the normal.");
        if (named.has("second_tangent") && !are_independent({contact.normal, contact.tangent, contact.second_tangent}))
            throw problem(fmt::format("the second tangent of contact \"{}\" is made of its normal and tangent", name),
                          "a plane has two directions", "Give it one at right angles to both.");
        for (const OwnContact& other : contacts_) {
            if (other.name == name)
                throw problem(fmt::format("two contacts are called \"{}\"", name), "", "Give each a name of its own.");
            if (other.normal == contact.normal && other.tangent == contact.tangent)
                throw problem(fmt::format("contacts \"{}\" and \"{}\" are one", other.name, name),
                              "their normals and tangents are the same, and forces between them not determined");
        }
        if (contacts_.size() >= parameters::most_contacts)
            throw problem(fmt::format("there are more than {} contacts", parameters::most_contacts),
                          "each event solves for all that touch");
        contacts_.push_back(std::move(contact));
    }

    const ElasticPart& part_;
    base::Place place_;
    std::vector<OwnContact> contacts_;
};

}  // namespace

std::span<const std::string_view> contact_keys() {
    static const std::vector<std::string_view> keys = [] {
        std::vector<std::string_view> all{"node", "set", "against"};
        for (const parameters::ContactField& field : parameters::contact_fields())
            all.push_back(field.key);
        return all;
    }();
    return keys;
}

std::vector<OwnContact> contacts_at(const ElasticPart& part, const std::vector<NamedContact>& named) {
    ContactMaker maker(part);
    for (const NamedContact& each : named)
        maker.take(each);
    return maker.finish();
}

std::vector<double> rows_along(const ElasticPart& part, const NamedOutput& named) {
    return ContactMaker(part).output_rows(named);
}

// "35.z", "x1 -x2"
std::string name_of(const NamedOutput& named, const std::string& fallback) {
    if (!named.name.empty()) return named.name;
    const auto* direction = std::get_if<std::string>(&named.direction);
    if (direction == nullptr) return fallback;
    return named.node.empty() ? *direction : named.node + "." + *direction;
}

namespace {

// labels of a part with those of further rows behind them
ElasticPart with_recovered(const reduction::Reduction& reduction) {
    ElasticPart labelled;
    labelled.labels = reduction.part.labels;
    labelled.sets = reduction.part.sets;
    for (const reduction::RowLabel& label : reduction.recovered)
        labelled.labels.push_back(label);
    return labelled;
}

void expect_own_name(const OwnOutput& output, const std::vector<OwnOutput>& before,
                     const std::vector<OwnContact>& contacts, const ElasticPart& part, const base::Place& place) {
    const auto is_called_so = [&](const auto& other) { return other.name == output.name; };
    const bool is_output = std::any_of(before.begin(), before.end(), is_called_so);
    const bool is_contact = std::any_of(contacts.begin(), contacts.end(), is_called_so);
    const bool is_row = std::any_of(part.labels.begin(), part.labels.end(),
                                    [&](const reduction::RowLabel& label) { return describe(label) == output.name; });
    if (is_output || is_contact || is_row)
        throw refusal(place, fmt::format("the name \"{}\" is taken", output.name),
                      is_output    ? "another output has it"
                      : is_contact ? "a contact has it"
                                   : "a row has it",
                      "Give the output a name of its own.");
}

}  // namespace

std::vector<OwnOutput> outputs_at(const reduction::Reduction& reduction, const std::vector<NamedOutput>& named,
                                  const std::vector<OwnContact>& contacts) {
    const std::size_t rows = reduction.part.labels.size();
    const ElasticPart labelled = with_recovered(reduction);
    ContactMaker maker(labelled);
    std::vector<OwnOutput> outputs;
    for (NamedOutput each : named) {
        // a number for each row says nothing of those that are recovered
        auto* numbers = std::get_if<std::vector<double>>(&each.direction);
        if (numbers != nullptr && each.node.empty() && numbers->size() == rows) numbers->resize(labelled.labels.size());
        const std::vector<double> all = maker.output_rows(each);
        OwnOutput output{name_of(each, fmt::format("output{}", outputs.size() + 1)),
                         {all.begin(), all.begin() + static_cast<long>(rows)}};
        for (std::size_t k = rows; k < all.size(); ++k)
            for (std::size_t row = 0; row < rows; ++row)
                output.weights[row] +=
                    all[k] * reduction.recovery(static_cast<Eigen::Index>(k - rows), static_cast<Eigen::Index>(row));
        expect_own_name(output, outputs, contacts, reduction.part, each.place);
        outputs.push_back(std::move(output));
    }
    return outputs;
}

void share_preload(parameters::OwnStructure& own, const std::vector<NamedContact>& named, const base::Place& place) {
    std::vector<OwnContact>& contacts = own.contacts;
    const bool has_shares =
        std::any_of(named.begin(), named.end(), [](const NamedContact& each) { return each.has("preload_share"); });
    const auto is_there = [](double value) { return value != 0.0; };
    const bool has_load = std::any_of(own.load.begin(), own.load.end(), is_there);
    const bool has_overlap = std::any_of(contacts.begin(), contacts.end(),
                                         [](const OwnContact& contact) { return contact.initial_gap < 0.0; });
    if (has_shares && (has_load || has_overlap))
        throw refusal(place,
                      has_load ? "a load stands beside shares of the preload"
                               : "a negative gap stands beside shares of the preload",
                      "the normal forces at rest follow from one of them", "Take one of them out.");
    if (has_load || has_overlap) return;
    for (OwnContact& contact : contacts) {
        if (!has_shares && contact.initial_gap == 0.0) contact.preload_share = 1.0;
        if (contact.preload_share > 0.0 && contact.initial_gap > 0.0)
            throw refusal(place, "contact \"" + contact.name + "\" is open and has a share of the preload",
                          "at rest nothing presses what does not touch", "Take out its gap, or its share.");
        if (contact.preload_share == 0.0 && contact.initial_gap == 0.0)
            throw refusal(place, "contact \"" + contact.name + "\" touches without load",
                          "whether it is closed at rest is not determined", "Give it a preload_share or a gap.");
    }
    // a body may fly towards a surface that it does not touch yet
    const bool is_flying = std::any_of(own.initial_velocity.begin(), own.initial_velocity.end(), is_there);
    if (!is_flying && std::none_of(contacts.begin(), contacts.end(),
                                   [](const OwnContact& contact) { return contact.preload_share > 0.0; }))
        throw refusal(place, "nothing presses the structure on its contacts", "all of them are open",
                      "Give one no gap, or a negative one, or the structure an initial_velocity.");
}

}  // namespace stridor::io
