// The peer's C: Pinocchio's algorithms over CasADi's symbols, written out by CasADi for float.
//
// In: an arm that model.py has read from a URDF, a folder, `plain` or `snapped`. Out: a file
// peer_FUNCTION.c in the folder for each function, with results in the order in which homogen has
// them. `snapped` gives CasADi what it cannot find itself: residues of right angles below 1e-9 are
// zero, common subexpressions are merged.

#include <casadi/casadi.hpp>

#include "pinocchio/autodiff/casadi.hpp"
#include "pinocchio/algorithm/aba.hpp"
#include "pinocchio/algorithm/crba.hpp"
#include "pinocchio/algorithm/frames.hpp"
#include "pinocchio/algorithm/jacobian.hpp"
#include "pinocchio/algorithm/kinematics.hpp"
#include "pinocchio/algorithm/rnea.hpp"
#include "pinocchio/multibody.hpp"
#include "pinocchio/multibody/joint.hpp"

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace pin = pinocchio;
using casadi::SX;
using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
using Matrix6 = Eigen::Matrix<SX, 6, Eigen::Dynamic>;

static double snapped(double value)
{
    const double nearest = std::round(value);
    return std::abs(value - nearest) < 1e-9 ? nearest : value;
}

/* Numbers of a file, one after the other. */
struct Numbers {
    std::ifstream file;
    bool snap;

    double next()
    {
        double number = NAN;
        file >> number;
        return number;
    }

    Eigen::Vector3d vector()
    {
        Eigen::Vector3d vector;
        for (double &entry : vector)
            entry = next();
        return vector;
    }

    pin::SE3 placement()
    {
        pin::SE3 placement;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                placement.rotation()(row, column) = next();
        placement.translation() = vector();
        if (snap) {
            placement.rotation() = placement.rotation().unaryExpr(&snapped);
            placement.translation() = placement.translation().unaryExpr(&snapped);
        }
        return placement;
    }
};

static pin::Model read(Numbers numbers)
{
    pin::Model arm;
    const int joints = int(numbers.next());
    for (int joint = 0; joint < joints; ++joint) {
        const int axis = int(numbers.next());
        const pin::SE3 at = numbers.placement();
        const std::string name = std::to_string(joint);
        if (axis == 0)
            arm.addJoint(joint, pin::JointModelRX(), at, name);
        else if (axis == 1)
            arm.addJoint(joint, pin::JointModelRY(), at, name);
        else
            arm.addJoint(joint, pin::JointModelRZ(), at, name);
        const double mass = numbers.next();
        const Eigen::Vector3d centre = numbers.vector();
        const Eigen::Vector3d first = numbers.vector(), second = numbers.vector();
        const pin::Symmetric3 inertia(first[0], first[1], first[2], second[0], second[1], second[2]);
        arm.appendBodyToJoint(joint + 1, pin::Inertia(mass, centre, inertia), pin::SE3::Identity());
    }
    arm.addFrame(pin::Frame("tip", joints, 0, numbers.placement(), pin::OP_FRAME));
    return arm;
}

static Vector entries(const SX &symbols)
{
    Vector vector(symbols.size1());
    for (int i = 0; i < symbols.size1(); ++i)
        vector[i] = symbols(i);
    return vector;
}

int main(int count, char **words)
{
    if (count != 4) {
        std::cerr << "usage: generate MODEL FOLDER (plain | snapped)\n";
        return 2;
    }
    const std::string folder = words[2], how = words[3];
    const pin::Model numbers = read({std::ifstream(words[1]), how == "snapped"});
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
        casadi::CodeGenerator generator("peer_" + name + ".c", {{"casadi_real", "float"}});
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

    // Of both conventions the one with fewer operations.
    data.M.fill(SX(0));
    pin::crba(model, data, eq, pin::Convention::LOCAL);
    out.clear();
    for (int row = 0; row < joints; ++row)
        for (int column = 0; column < joints; ++column)
            out.push_back(data.M(std::min(row, column), std::max(row, column)));
    write("mass_matrix", {q}, out);
    pin::aba(model, data, eq, eqd, ex, pin::Convention::LOCAL);
    write("forward_dynamics", {q, qd, x}, vector(data.ddq));
}
