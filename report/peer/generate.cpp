// The peer's C: Pinocchio's algorithms over CasADi's symbols, written out by CasADi.
//
// In: a robot that model.py has read from a URDF, a folder, the type of number in C, `plain` or
// `snapped`, and names of functions where not all are wanted. Out: a file peer_FUNCTION.c in the folder
// for each function, with results in the order in which homogen has them. `snapped` gives CasADi what it cannot find itself: residues of right
// angles below 1e-9 are zero, common subexpressions are merged.

#include "generate.hpp"

#include "pinocchio/algorithm/aba.hpp"
#include "pinocchio/algorithm/crba.hpp"
#include "pinocchio/algorithm/frames.hpp"
#include "pinocchio/algorithm/jacobian.hpp"
#include "pinocchio/algorithm/kinematics.hpp"
#include "pinocchio/algorithm/rnea.hpp"

#include "model.hpp"

#include <fstream>
#include <iostream>

namespace pin = pinocchio;

int main(int count, char **words)
{
    if (count < 5) {
        std::cerr << "usage: generate MODEL FOLDER (double | float) (plain | snapped) [FUNCTION …]\n";
        return 2;
    }
    const bool snapped = words[4] == std::string("snapped");
    std::ifstream text(words[1]);
    Writer to(robot_of({text, snapped}), words[2], words[3], snapped, {words + 5, words + count});
    const SX q = to.q, qd = to.qd, x = to.x;
    const Vector eq = to.eq, eqd = to.eqd, ex = to.ex;
    const auto &model = to.model;
    auto &data = to.data;
    const auto tip = model.getFrameId("tip");
    std::vector<SX> out;

    // Rows of (R, t).
    pin::forwardKinematics(model, data, eq);
    pin::updateFramePlacement(model, data, tip);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            out.push_back(data.oMf[tip].rotation()(row, column));
        out.push_back(data.oMf[tip].translation()[row]);
    }
    to.write("forward_kinematics", {q}, out);

    Matrix6 jacobian = Matrix6::Constant(6, model.nv, SX(0));
    pin::computeJointJacobians(model, data, eq);
    pin::updateFramePlacement(model, data, tip);
    pin::getFrameJacobian(model, data, tip, pin::LOCAL_WORLD_ALIGNED, jacobian);
    to.write("geometric_jacobian", {q}, to.columns(jacobian));

    const auto vector = [&](const auto &values) {
        std::vector<SX> out;
        for (int i = 0; i < model.nv; ++i)
            out.push_back(values[i]);
        return out;
    };
    pin::computeGeneralizedGravity(model, data, eq);
    to.write("gravity", {q}, vector(data.g));
    pin::rnea(model, data, eq, eqd, ex);
    to.write("inverse_dynamics", {q, qd, x}, vector(data.tau));
    pin::nonLinearEffects(model, data, eq, eqd);
    to.write("bias", {q, qd}, vector(data.nle));

    pin::computeMinverse(model, data, eq);
    to.write("mass_matrix_inverse", {q}, to.symmetric(data.Minv));

    // In link frames, which takes fewer operations, and as Pinocchio does it unless asked.
    for (const auto &[convention, suffix] :
         {std::pair(pin::Convention::LOCAL, ""), std::pair(pin::Convention::WORLD, "_world")}) {
        data.M.fill(SX(0));
        pin::crba(model, data, eq, convention);
        to.write(std::string("mass_matrix") + suffix, {q}, to.symmetric(data.M));
        pin::aba(model, data, eq, eqd, ex, convention);
        to.write(std::string("forward_dynamics") + suffix, {q, qd, x}, vector(data.ddq));
    }
    write_derivatives(to);
}
