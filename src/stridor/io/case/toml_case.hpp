#pragma once

#include "stridor/io/case/material_pairs.hpp"
#include "stridor/io/case/own_structure/toml_structure.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace stridor::io {

/// Gives the motion of a sampled drive by the path of its file. A reader for users who may name no files is one that
/// opens none.
using SamplesReader = std::function<recordings::SampledMotion(const std::string& path)>;

/// Gives a table of friction by the path of its file.
using FrictionReader = std::function<recordings::SampledFriction(const std::string& path)>;

/// Gives a table of force by the path of its file.
using ForceReader = std::function<recordings::SampledForce(const std::string& path)>;

/// Gives the coefficients of a pair of materials by the path of its file and by its name there.
using PairReader = std::function<parameters::MaterialPair(const std::string& path, const std::string& name)>;

/// Makes the structure of a document that has one of its own, as [structure].
using StructureReader = std::function<std::shared_ptr<const parameters::OwnStructure>(const TomlDocument&)>;

/// How reading a case reaches what does not stand in its document.
struct CaseReaders {
    SamplesReader samples = recordings::read_sampled_file;
    StructureReader structure = read_own_structure;
    FrictionReader friction = recordings::read_friction_file;
    ForceReader force = recordings::read_force_file;
    PairReader pair = read_material_pair;
};

/// Returns readers for a document whose user may name no files: the numbers of its structure stand in it.
CaseReaders readers_without_files();

/// Reads a case: keys come from the field table, numbers are SI (angles in deg), text carries its unit.
///
/// Everything in [joint], [plate], [contact] and [drive] that belongs to the case must be there, except the laws of the
/// contact and of the joint, exponent and viscosity of Stribeck's curve, and what follows the temperature
/// (`read_temperature_table`).
/// The rest has defaults. Overrides win; a key of the file that an override made meaningless (drive.amplitude after
/// `--set drive.kind=constant`) is left out, and so is one
/// that a change of the kind in the file left behind (`case_warnings`). A section [chart] is not looked at. A sampled
/// drive's CSV is looked for beside the file (given by an override: in the current folder).
/// Throws `Error` (input) with all that is wrong, each with file, line, column and source line, for anything else than
/// a case that can be simulated.
///
/// A file with `[[joint]]` tables has several joints on its plate, each with a name and the keys of [joint], and with
/// those of [contact] in [joint.contact]. One with [structure] has a structure of its own (`read_own_structure`), and
/// neither [joint] nor [plate]; the files that this names are opened.
parameters::Case read_case(const TomlSource& source);

/// Reads a case from a document that is parsed already. Throws as above.
parameters::Case read_case(const TomlDocument& document, const CaseReaders& readers = {});

/// Reads a case from a file; "-" is standard input. Throws as above, and `Error` (io) for a file that cannot be read.
parameters::Case read_case(const std::string& path, std::vector<std::string> overrides = {});

/// Returns the case a chart starts from, out of a document that is parsed already. Whether its values fit together is
/// left to the chart, whose axes replace two of them.
parameters::Case read_base_case(const TomlDocument& document, const CaseReaders& readers = {});

/// Returns what reading a case leaves out and its user should know: keys that mean nothing for the kinds the file
/// chooses, and have a value that `stridor init` writes (with any other they are errors).
std::vector<base::Complaint> case_warnings(const TomlDocument& document);

/// Puts the value of one entry into a case. Throws `Error` (input) with the entry's place.
void assign(parameters::CaseToSet at, const parameters::Field& field, const TomlEntry& entry);

/// Says whether a file must say this, whenever it belongs to the case.
bool is_required(const parameters::Field& field);

}  // namespace stridor::io
