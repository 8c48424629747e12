// The peer itself: Pinocchio's algorithms from its templates, behind C functions.
//
// In: what pinocchio.hpp says. Out: a function peer_FUNCTION for each, with CasADi's signature and the
// results in the order in which homogen has them. Without a place for them they stay where
// Pinocchio's users read them, in its own data.

#include "pinocchio/algorithm/aba.hpp"
#include "pinocchio/algorithm/crba.hpp"
#include "pinocchio/algorithm/jacobian.hpp"
#include "pinocchio/algorithm/kinematics.hpp"
#include "pinocchio/algorithm/rnea.hpp"

#include "pinocchio.hpp"

using Matrix6 = Eigen::Matrix<REAL, 6, Eigen::Dynamic>;
static Matrix6 jacobian = Matrix6::Zero(6, model.nv);

PEER(forward_kinematics)
{
    pin::forwardKinematics(model, data, coordinates(in[0]));
    const auto &pose = pin::updateFramePlacement(model, data, tip);
    if (REAL *place = out[0])
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                *place++ = pose.rotation()(row, column);
            *place++ = pose.translation()[row];
        }
    return 0;
}

PEER(geometric_jacobian)
{
    pin::computeJointJacobians(model, data, coordinates(in[0]));
    pin::updateFramePlacement(model, data, tip);
    pin::getFrameJacobian(model, data, tip, pin::LOCAL_WORLD_ALIGNED, jacobian);
    if (REAL *place = out[0])
        for (int column = 0; column < model.nv; ++column)
            for (int row : {3, 4, 5, 0, 1, 2})
                *place++ = jacobian(row, column);
    return 0;
}

PEER(gravity)
{
    give(out[0], pin::computeGeneralizedGravity(model, data, coordinates(in[0])));
    return 0;
}

PEER(inverse_dynamics)
{
    give(out[0], pin::rnea(model, data, coordinates(in[0]), velocities(in[1]), velocities(in[2])));
    return 0;
}

PEER(bias)
{
    give(out[0], pin::nonLinearEffects(model, data, coordinates(in[0]), velocities(in[1])));
    return 0;
}

PEER(mass_matrix_inverse)
{
    give_symmetric(out[0], pin::computeMinverse(model, data, coordinates(in[0])));
    return 0;
}

static int mass_matrix(const REAL **in, REAL **out, pin::Convention convention)
{
    give_symmetric(out[0], pin::crba(model, data, coordinates(in[0]), convention));
    return 0;
}

static int forward_dynamics(const REAL **in, REAL **out, pin::Convention convention)
{
    const auto q = coordinates(in[0]), qd = velocities(in[1]), tau = velocities(in[2]);
    give(out[0], pin::aba(model, data, q, qd, tau, convention));
    return 0;
}

// In link frames, and as Pinocchio does it unless asked.
PEER(mass_matrix)
{
    return mass_matrix(in, out, pin::Convention::LOCAL);
}

PEER(mass_matrix_world)
{
    return mass_matrix(in, out, pin::Convention::WORLD);
}

PEER(forward_dynamics)
{
    return forward_dynamics(in, out, pin::Convention::LOCAL);
}

PEER(forward_dynamics_world)
{
    return forward_dynamics(in, out, pin::Convention::WORLD);
}
