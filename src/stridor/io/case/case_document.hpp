#pragma once

#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"

namespace stridor::io {

/// How much of a case its document holds.
enum class CaseDepth {
    fields,          // what keys can change: without the structure that no builder makes
    whole,           // that structure with all its numbers, too
    whole_and_idle,  // and fields that would mean something with another choice
};

/// Returns the document that a file of this case would be, with each number as it is and no places. Samples of a drive
/// do not stand in it: whoever reads it hands them over, and the structure too where it was left out (`CaseReaders`).
TomlDocument document_of(const parameters::Case& c, CaseDepth depth = CaseDepth::fields);

}  // namespace stridor::io
