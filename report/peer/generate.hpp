// A robot over CasADi's symbols, and C of what is computed of it.
//
// In: a robot of numbers, a folder, the type of number in C, whether common subexpressions are merged,
// which functions are wanted. Out: a file peer_FUNCTION.c in the folder for each of these.
#pragma once

#include <casadi/casadi.hpp>

#include "pinocchio/autodiff/casadi.hpp"
#include "pinocchio/multibody.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using casadi::SX;
using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
using Matrix6 = Eigen::Matrix<SX, 6, Eigen::Dynamic>;

struct Writer {
    std::string folder, real;
    bool merges;
    /* Names of functions; all where it is empty. */
    std::set<std::string> wanted;
    pinocchio::ModelTpl<SX> model;
    pinocchio::DataTpl<SX> data;
    /* q, q̇, and q̈ or τ: as CasADi has them, and as Pinocchio takes them. */
    SX q, qd, x;
    Vector eq, eqd, ex;

    Writer(const pinocchio::Model &numbers, std::string folder, std::string real, bool merges,
        std::set<std::string> wanted)
        : folder(std::move(folder)), real(std::move(real)), merges(merges), wanted(std::move(wanted)),
          model(numbers.cast<SX>()), data(model), q(SX::sym("q", model.nq)), qd(SX::sym("qd", model.nv)),
          x(SX::sym("x", model.nv)), eq(entries(q)), eqd(entries(qd)), ex(entries(x))
    {
    }

    void write(const std::string &name, const std::vector<SX> &in, const std::vector<SX> &out) const
    {
        if (!wanted.empty() && !wanted.count(name))
            return;
        casadi::Dict options;
        options["cse"] = merges;
        const casadi::Function function("peer_" + name, in, {SX::densify(SX::vertcat(out))}, options);
        casadi::CodeGenerator generator("peer_" + name + ".c", {{"casadi_real", real}});
        generator.add(function);
        generator.generate(folder + "/");
    }

    /* A matrix by rows, behind what there is. */
    template <typename Matrix>
    static void append(std::vector<SX> &out, const Matrix &matrix)
    {
        for (int row = 0; row < matrix.rows(); ++row)
            for (int column = 0; column < matrix.cols(); ++column)
                out.push_back(matrix(row, column));
    }

    /* All of a matrix of which Pinocchio computes the upper triangle. */
    template <typename Matrix>
    std::vector<SX> symmetric(const Matrix &upper) const
    {
        std::vector<SX> out;
        for (int row = 0; row < model.nv; ++row)
            for (int column = 0; column < model.nv; ++column)
                out.push_back(upper(std::min(row, column), std::max(row, column)));
        return out;
    }

    /* A matrix (u; b) for each velocity; Pinocchio's rows are linear, then angular. */
    std::vector<SX> columns(const Matrix6 &matrices) const
    {
        std::vector<SX> out;
        for (int column = 0; column < model.nv; ++column)
            for (int row : {3, 4, 5, 0, 1, 2})
                out.push_back(matrices(row, column));
        return out;
    }

    static Vector entries(const SX &symbols)
    {
        Vector vector(symbols.size1());
        for (int i = 0; i < symbols.size1(); ++i)
            vector[i] = symbols(i);
        return vector;
    }
};

/* Derivatives, and what else controllers and estimators ask for. */
void write_derivatives(Writer &to);
