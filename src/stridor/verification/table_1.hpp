#pragma once

#include "stridor/analysis/rates.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/verification/check.hpp"

#include <array>
#include <vector>

/// Table 1 of Elmaian et al. (2012): the four columns under their sinusoidal drive, 1 s. Irregular motions depend on
/// every rounding, so these are the exact engine's own digits, which every build of it repeats.
namespace stridor::verification {

/// One column of Table 1.
struct Table1Column {
    parameters::PaperCase which;
    /// [1] of a share of time, against the exact engine: the largest of beta_2 at h = 1, 1/2, 1/4 and 1/8 us. It does
    /// not fall with h: a step moves the instants of impacts, irregular motion forgets them within milliseconds, and
    /// what is left is the spread of shares over 1 s. Halving h changes the shares by up to 0.0150 (quiet, which takes
    /// one of two courses), 0.0064 (squeal), 0.0128 (squeak) and 0.0105 (creak).
    double beta_2_error;
    std::array<analysis::Rates, 2> rates;  // [1] going, coming; of the whole phase
};

inline constexpr std::array<Table1Column, 4> table_1{{
    {parameters::PaperCase::quiet,
     .0150,
     {{{.slip = .8807455, .stick = .0731810, .separation = .0460735},
       {.slip = .9491487, .stick = .0502807, .separation = .0005706}}}},
    {parameters::PaperCase::squeal,
     .0205,
     {{{.slip = .1487222, .stick = .1726952, .separation = .6785826},
       {.slip = .8492444, .stick = .0565966, .separation = .0941591}}}},
    {parameters::PaperCase::squeak,
     .0151,
     {{{.slip = .4280422, .stick = .4367432, .separation = .1352146},
       {.slip = .5641435, .stick = .4358565, .separation = .0}}}},
    {parameters::PaperCase::creak,
     .0071,
     {{{.slip = .1294289, .stick = .8687976, .separation = .0017736},
       {.slip = .0772079, .stick = .9227921, .separation = .0}}}},
}};

/// [1] the digits are stored to seven places.
inline constexpr double table_1_exact_tolerance = 1e-6;

/// [1] a quarter more than the error of beta_2 that was measured.
constexpr double beta_2_tolerance(const Table1Column& column) {
    return 1.25 * column.beta_2_error;
}

/// The shares of both engines.
std::vector<Check> table_1_checks();

}  // namespace stridor::verification
