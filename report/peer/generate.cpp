// The peer's C: Pinocchio's algorithms over CasADi's symbols, written out by CasADi.
//
// In: an arm that model.py has read from a URDF, a folder, the type of number in C, `plain` or
// `snapped`. Out: a file peer_FUNCTION.c in the folder for each function, with results in the order
// in which homogen has them. `snapped` gives CasADi what it cannot find itself: residues of right
// angles below 1e-9 are zero, common subexpressions are merged.

#include <casadi/casadi.hpp>

#include "pinocchio/autodiff/casadi.hpp"
#include "pinocchio/algorithm/aba.hpp"
#include "pinocchio/algorithm/crba.hpp"
#include "pinocchio/algorithm/frames.hpp"
#include "pinocchio/algorithm/jacobian.hpp"
#include "pinocchio/algorithm/kinematics.hpp"
#include "pinocchio/algorithm/rnea.hpp"

#include "model.hpp"

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace pin = pinocchio;
using casadi::SX;
using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
using Matrix6 = Eigen::Matrix<SX, 6, Eigen::Dynamic>;

static Vector entries(const SX &symbols)
{
    Vector vector(symbols.size1());
    for (int i = 0; i < symbols.size1(); ++i)
        vector[i] = symbols(i);
    return vector;
}

int main(int count, char **words)
{
    if (count != 5) {
        std::cerr << "usage: generate MODEL FOLDER (double | float) (plain | snapped)\n";
        return 2;
    }
    const std::string folder = words[2], real = words[3], how = words[4];
    std::ifstream text(words[1]);
    const pin::Model numbers = arm_of({text, how == "snapped"});
    const auto tip = numbers.getFrameId("tip");
    const auto model = numbers.cast<SX>();
    pin::DataTpl<SX> data(model);
    const int joints = model.nv;
    const SX q = SX::sym("q", joints), qd = SX::sym("qd", joints), x = SX::sym("x", joints);
    const Vector eq = entries(q), eqd = entries(qd), ex = entries(x);

    const auto write = [&](const std::string &name, const std::vector<SX> &in, std::vector<SX> out) {
        casadi::Dict options;
        options["cse"] = how == "snapped";
        const casadi::Function function("peer_" + name, in, {SX::densify(SX::vertcat(out))}, options);
        casadi::CodeGenerator generator("peer_" + name + ".c", {{"casadi_real", real}});
        generator.add(function);
        generator.generate(folder + "/");
    };
    std::vector<SX> out;

    // Rows of (R, t).
    pin::forwardKinematics(model, data, eq);
    pin::updateFramePlacement(model, data, tip);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            out.push_back(data.oMf[tip].rotation()(row, column));
        out.push_back(data.oMf[tip].translation()[row]);
    }
    write("forward_kinematics", {q}, out);

    // A screw (u; b) for each joint; Pinocchio's rows are linear, then angular.
    Matrix6 jacobian = Matrix6::Constant(6, joints, SX(0));
    pin::computeJointJacobians(model, data, eq);
    pin::updateFramePlacement(model, data, tip);
    pin::getFrameJacobian(model, data, tip, pin::LOCAL_WORLD_ALIGNED, jacobian);
    out.clear();
    for (int joint = 0; joint < joints; ++joint)
        for (int row : {3, 4, 5, 0, 1, 2})
            out.push_back(jacobian(row, joint));
    write("geometric_jacobian", {q}, out);

    const auto vector = [&](const auto &values) {
        std::vector<SX> out;
        for (int i = 0; i < joints; ++i)
            out.push_back(values[i]);
        return out;
    };
    pin::computeGeneralizedGravity(model, data, eq);
    write("gravity", {q}, vector(data.g));
    pin::rnea(model, data, eq, eqd, ex);
    write("inverse_dynamics", {q, qd, x}, vector(data.tau));
    pin::nonLinearEffects(model, data, eq, eqd);
    write("bias", {q, qd}, vector(data.nle));

    // All of a matrix of which Pinocchio computes the upper triangle.
    const auto symmetric = [&](const auto &upper) {
        std::vector<SX> out;
        for (int row = 0; row < joints; ++row)
            for (int column = 0; column < joints; ++column)
                out.push_back(upper(std::min(row, column), std::max(row, column)));
        return out;
    };
    pin::computeMinverse(model, data, eq);
    write("mass_matrix_inverse", {q}, symmetric(data.Minv));

    // In link frames, which takes fewer operations, and as Pinocchio does it unless asked.
    for (const auto &[convention, suffix] :
         {std::pair(pin::Convention::LOCAL, ""), std::pair(pin::Convention::WORLD, "_world")}) {
        data.M.fill(SX(0));
        pin::crba(model, data, eq, convention);
        write(std::string("mass_matrix") + suffix, {q}, symmetric(data.M));
        pin::aba(model, data, eq, eqd, ex, convention);
        write(std::string("forward_dynamics") + suffix, {q, qd, x}, vector(data.ddq));
    }
}
