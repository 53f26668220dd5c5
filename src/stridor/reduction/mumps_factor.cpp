#include "stridor/reduction/mumps_factor.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/opened_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#if STRIDOR_HAS_MUMPS
#    include <dmumps_c.h>
#endif

namespace stridor::reduction {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

#if STRIDOR_HAS_MUMPS

namespace {

/// MUMPS, opened when it is first asked for.
struct Mumps {
    base::OpenedLibrary library{STRIDOR_MUMPS_LIBRARY};
    decltype(&::dmumps_c) call = library.function("dmumps_c");
};

const Mumps& mumps() {
    static const Mumps opened;
    if (!opened.library.is_whole())
        throw Error(ErrorKind::io,
                    {"MUMPS is not on this machine", fmt::format("{} cannot be opened", STRIDOR_MUMPS_LIBRARY),
                     "Leave out --solver, or install it, on Debian with: apt install libmumps-seq-5.5"});
    return opened;
}

// what MUMPS is asked to do
constexpr int to_begin = -1;
constexpr int to_analyse_and_factorise = 4;
constexpr int to_factorise = 2;
constexpr int to_solve = 3;
constexpr int to_end = -2;

// what INFOG(1) says
constexpr int needs_more_integers = -8;
constexpr int needs_more_numbers = -9;
constexpr int zero_pivot = -10;

// numbers of the Users' guide count from one
int& icntl(DMUMPS_STRUC_C& data, int number) {
    return data.icntl[number - 1];
}

int infog(const DMUMPS_STRUC_C& data, int number) {
    return data.infog[number - 1];
}

}  // namespace

struct MumpsFactor::Held {
    DMUMPS_STRUC_C data{};

    Held() {
        constexpr int own_process = -987654;  // the communicator of the sequential library
        data.comm_fortran = own_process;
        data.par = 1;
        data.sym = 2;  // general symmetric
        data.job = to_begin;
        mumps().call(&data);
        for (const int stream : {1, 2, 3, 4})  // no messages
            icntl(data, stream) = 0;
        constexpr int metis = 5;
        icntl(data, 7) = metis;
    }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held() {
        data.job = to_end;
        mumps().call(&data);
    }
};

MumpsFactor::MumpsFactor(const SparseMatrix& matrix, FactorUse use)
    : held_(std::make_unique<Held>()),
      diagonal_(matrix.diagonal().cwiseAbs()) {
    std::vector<int> rows;
    std::vector<int> columns;
    std::vector<double> values;
    for (Index column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            if (entry.row() < column) continue;
            rows.push_back(static_cast<int>(entry.row()) + 1);
            columns.push_back(static_cast<int>(column) + 1);
            values.push_back(entry.value());
        }
    DMUMPS_STRUC_C& data = held_->data;
    data.n = static_cast<int>(matrix.rows());
    data.nnz = static_cast<std::int64_t>(values.size());
    data.irn = rows.data();
    data.jcn = columns.data();
    data.a = values.data();
    if (use == FactorUse::counting) icntl(data, 31) = 1;  // half of the memory, where other factors are held
    data.job = to_analyse_and_factorise;
    mumps().call(&data);
    // pivots put off take more room than it had foreseen
    constexpr int most_room = 400;  // [%] beyond what was foreseen
    while ((infog(data, 1) == needs_more_integers || infog(data, 1) == needs_more_numbers) &&
           icntl(data, 14) < most_room) {
        icntl(data, 14) *= 2;
        data.job = to_factorise;
        mumps().call(&data);
    }
    data.irn = nullptr;
    data.jcn = nullptr;
    data.a = nullptr;
    if (infog(data, 1) < 0 && infog(data, 1) != zero_pivot)
        throw Error(ErrorKind::numerical,
                    {"MUMPS could not factorise the part",
                     fmt::format("it ended with INFOG(1) = {}, INFOG(2) = {}", infog(data, 1), infog(data, 2)),
                     "Does it fit into the memory?"});
}

MumpsFactor::~MumpsFactor() = default;

bool MumpsFactor::is_whole() const {
    return infog(held_->data, 1) >= 0;
}

Index MumpsFactor::negative_pivots() const {
    constexpr int negative = 12;
    return infog(held_->data, negative);
}

MatrixXd MumpsFactor::solve(const MatrixXd& right) const {
    MatrixXd answers = right;
    if (right.size() == 0) return answers;
    DMUMPS_STRUC_C& data = held_->data;
    data.nrhs = static_cast<int>(right.cols());
    data.lrhs = static_cast<int>(right.rows());
    data.rhs = answers.data();
    data.job = to_solve;
    mumps().call(&data);
    data.rhs = nullptr;
    if (infog(data, 1) < 0)
        throw Error(ErrorKind::numerical, {"MUMPS could not solve for a load",
                                           fmt::format("it ended with INFOG(1) = {}", infog(data, 1)), ""});
    return answers;
}

double MumpsFactor::weakest_pivot() const {
    if (!is_whole() || diagonal_.size() == 0 || !(diagonal_.minCoeff() > 0.0)) return 0.0;
    const VectorXd scale = diagonal_.cwiseSqrt();
    // a load that no motion is free of
    VectorXd load(scale.size());
    for (Index row = 0; row < load.size(); ++row)
        load[row] = scale[row] * static_cast<double>(1 + row * row % 17 - row % 5);
    double weakest = 1.0;
    constexpr int most_steps = 6;
    Index from = -1;
    for (int step = 0; step < most_steps; ++step) {
        const VectorXd moved = scale.cwiseProduct(solve(load).col(0));
        if (!moved.allFinite()) return 0.0;
        if (from >= 0) weakest = std::min(weakest, 1.0 / std::abs(moved[from] * scale[from]));
        Index softest = 0;
        moved.cwiseAbs().maxCoeff(&softest);
        if (softest == from) break;
        from = softest;
        load = VectorXd::Unit(load.size(), from);
    }
    return weakest;
}

#else

struct MumpsFactor::Held {};

MumpsFactor::MumpsFactor(const SparseMatrix&, FactorUse) {
    base::refuse("this stridor has no MUMPS", "it was built where its headers were missing",
                 "Leave out --solver, or install libmumps-headers-dev and libmumps-seq-5.5, and build anew.");
}

MumpsFactor::~MumpsFactor() = default;

bool MumpsFactor::is_whole() const {
    return false;
}

Index MumpsFactor::negative_pivots() const {
    return 0;
}

MatrixXd MumpsFactor::solve(const MatrixXd& right) const {
    return right;
}

double MumpsFactor::weakest_pivot() const {
    return 0.0;
}

#endif

}  // namespace stridor::reduction
