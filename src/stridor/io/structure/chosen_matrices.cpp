#include "stridor/io/structure/chosen_matrices.hpp"

#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

namespace stridor::io::structure {

namespace {

using recordings::refusal;
using Candidates = std::vector<const ListedMatrix*>;

// "XX" of KXX and MXX: matrices of one model share it
std::string model_of(const ListedMatrix& matrix) {
    return matrix.name.empty() ? "" : upper(matrix.name).substr(1);
}

// of KXX1: XX
std::string model_without_number(const ListedMatrix& matrix) {
    const std::string model = model_of(matrix);
    return model.substr(0, model.find_last_not_of("0123456789") + 1);
}

// a whole name that programs give to nothing else: KAA, KAAX, MXX, BGG; any set of degrees of freedom of Nastran's
// that a part may stand in; or a word
bool has_known_name(const ListedMatrix& matrix) {
    constexpr std::array<std::string_view, 10> models{"", "AA", "AAX", "XX", "GG", "HH", "FF", "LL", "NN", "PP"};
    constexpr std::array<std::string_view, 6> words{"STIFFNESS", "KSTIFF", "STIFF", "MASS", "MMASS", "DAMPING"};
    const std::string name = upper(matrix.name);
    return matrix.name.empty() || matrix.is_named_by_user ||
           std::find(models.begin(), models.end(), model_without_number(matrix)) != models.end() ||
           std::find(words.begin(), words.end(), name) != words.end();
}

Candidates of_role(const std::vector<ListedMatrix>& matrices, MatrixRole role) {
    Candidates found;
    for (const ListedMatrix& matrix : matrices)
        if (matrix.role == role && !matrix.is_passed_over && !matrix.entries.empty()) found.push_back(&matrix);
    return found;
}

// without those whose name alone does not tell what they are, and is not that of another: MUG1 is no mass, MSEAL
// beside KSEAL is one
void leave_strangers(Candidates& candidates, const Candidates& others) {
    std::erase_if(candidates, [&](const ListedMatrix* each) {
        return !has_known_name(*each) && std::none_of(others.begin(), others.end(), [&](const ListedMatrix* other) {
            return model_without_number(*other) == model_without_number(*each);
        });
    });
}

// those that fit, unless none does
void narrow(Candidates& candidates, const std::function<bool(const ListedMatrix&)>& fits) {
    Candidates fitting;
    for (const ListedMatrix* each : candidates)
        if (fits(*each)) fitting.push_back(each);
    if (!fitting.empty()) candidates = std::move(fitting);
}

std::string names_of(const Candidates& candidates) {
    std::string names;
    for (const ListedMatrix* each : candidates)
        names += (names.empty() ? "" : ", ") + (each->name.empty() ? each->file : each->name) +
                 (each->is_passed_over    ? " (rectangular or complex)"
                  : each->entries.empty() ? " (empty)"
                                          : "");
    return names;
}

const ListedMatrix* only(const Candidates& candidates, MatrixRole role) {
    if (candidates.size() < 2) return candidates.empty() ? nullptr : candidates.front();
    const ListedMatrix& last = *candidates.back();
    throw refusal(last.file, fmt::format("there is more than one {}", name_of(role)),
                  fmt::format("{} could be it", names_of(candidates)),
                  last.name.empty() ? fmt::format("Name one with --{} FILE, and leave out the others.", name_of(role))
                                    : "Name each matrix: --stiffness FILE:NAME --mass FILE:NAME.");
}

[[noreturn]] void refuse_lack(const std::vector<ListedMatrix>& matrices, MatrixRole role) {
    std::string files;
    Candidates named;
    for (const ListedMatrix& matrix : matrices) {
        if (files.find(matrix.file) == std::string::npos) files += (files.empty() ? "" : ", ") + matrix.file;
        if (!matrix.name.empty()) named.push_back(&matrix);
    }
    const std::string found = named.empty() ? "" : "; found are " + names_of(named);
    throw refusal(files, fmt::format("there is no {} among the files", name_of(role)),
                  "a structure vibrates by its stiffness and its mass" + found,
                  fmt::format("Add it, or name it with --{} FILE{}.", name_of(role), named.empty() ? "" : ":NAME"));
}

}  // namespace

PartMatrices chosen_matrices(const std::vector<ListedMatrix>& matrices) {
    Candidates stiffness = of_role(matrices, MatrixRole::stiffness);
    Candidates mass = of_role(matrices, MatrixRole::mass);
    Candidates damping = of_role(matrices, MatrixRole::damping);
    const Candidates every_mass = mass;
    leave_strangers(mass, stiffness);
    leave_strangers(damping, stiffness);
    leave_strangers(stiffness, every_mass);
    narrow(stiffness, [&](const ListedMatrix& each) {
        return std::any_of(mass.begin(), mass.end(), [&](const ListedMatrix* its) {
            return model_of(*its) == model_of(each) && (its->rows == each.rows || !each.labels.empty());
        });
    });
    PartMatrices chosen{.stiffness = only(stiffness, MatrixRole::stiffness)};
    if (chosen.stiffness == nullptr) refuse_lack(matrices, MatrixRole::stiffness);
    for (Candidates* others : {&mass, &damping}) {
        narrow(*others, [&](const ListedMatrix& each) { return model_of(each) == model_of(*chosen.stiffness); });
        narrow(*others, [&](const ListedMatrix& each) { return each.rows == chosen.stiffness->rows; });
    }
    chosen.mass = only(mass, MatrixRole::mass);
    if (chosen.mass == nullptr) refuse_lack(matrices, MatrixRole::mass);
    chosen.damping = only(damping, MatrixRole::damping);
    Candidates left;
    for (const ListedMatrix& matrix : matrices) {
        const bool is_chosen = &matrix == chosen.stiffness || &matrix == chosen.mass || &matrix == chosen.damping;
        if (is_chosen) continue;
        if (matrix.role == MatrixRole::structural_damping && !matrix.entries.empty())
            chosen.notes.push_back(fmt::format("{} holds structural damping, which is left out", matrix.name));
        else
            left.push_back(&matrix);
    }
    if (!left.empty())
        chosen.notes.push_back(
            fmt::format("left out, as it is not the stiffness, mass or damping: {}", names_of(left)));
    return chosen;
}

}  // namespace stridor::io::structure
