// The peer itself: Pinocchio's algorithms from its templates, behind C functions.
//
// In: REAL, the type of number; where it is linked, the text `peer_model`, which model.py wrote. Out: a
// function peer_FUNCTION for each, with CasADi's signature and the results in the order in which
// homogen has them. Without a place for them they stay where Pinocchio's users read them, in its own
// data.

#include "pinocchio/algorithm/aba.hpp"
#include "pinocchio/algorithm/crba.hpp"
#include "pinocchio/algorithm/frames.hpp"
#include "pinocchio/algorithm/jacobian.hpp"
#include "pinocchio/algorithm/kinematics.hpp"
#include "pinocchio/algorithm/rnea.hpp"

#include "model.hpp"

#include <sstream>

namespace pin = pinocchio;
using Vector = Eigen::Map<const Eigen::Matrix<REAL, Eigen::Dynamic, 1>>;
using Matrix6 = Eigen::Matrix<REAL, 6, Eigen::Dynamic>;

extern "C" const char peer_model[];

static pin::ModelTpl<REAL> read()
{
    std::istringstream text(peer_model);
    return arm_of({text, false}).cast<REAL>();
}

static const pin::ModelTpl<REAL> model = read();
static pin::DataTpl<REAL> data(model);
static const pin::FrameIndex tip = model.getFrameId("tip");
static Matrix6 jacobian = Matrix6::Zero(6, model.nv);

static Vector vector(const REAL *numbers)
{
    return Vector(numbers, model.nv);
}

template <typename Numbers>
static void give(REAL *place, const Numbers &numbers)
{
    if (place)
        std::copy(numbers.begin(), numbers.end(), place);
}

template <typename Matrix>
static void give_symmetric(REAL *place, const Matrix &upper)
{
    if (place)
        for (int row = 0; row < model.nv; ++row)
            for (int column = 0; column < model.nv; ++column)
                *place++ = upper(std::min(row, column), std::max(row, column));
}

#define PEER(name) \
    extern "C" __attribute__((visibility("default"))) int peer_##name( \
        const REAL **in, REAL **out, long long *, REAL *, int)

PEER(forward_kinematics)
{
    pin::forwardKinematics(model, data, vector(in[0]));
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
    pin::computeJointJacobians(model, data, vector(in[0]));
    pin::updateFramePlacement(model, data, tip);
    pin::getFrameJacobian(model, data, tip, pin::LOCAL_WORLD_ALIGNED, jacobian);
    if (REAL *place = out[0])
        for (int joint = 0; joint < model.nv; ++joint)
            for (int row : {3, 4, 5, 0, 1, 2})
                *place++ = jacobian(row, joint);
    return 0;
}

PEER(gravity)
{
    give(out[0], pin::computeGeneralizedGravity(model, data, vector(in[0])));
    return 0;
}

PEER(inverse_dynamics)
{
    give(out[0], pin::rnea(model, data, vector(in[0]), vector(in[1]), vector(in[2])));
    return 0;
}

PEER(bias)
{
    give(out[0], pin::nonLinearEffects(model, data, vector(in[0]), vector(in[1])));
    return 0;
}

PEER(mass_matrix_inverse)
{
    give_symmetric(out[0], pin::computeMinverse(model, data, vector(in[0])));
    return 0;
}

static int mass_matrix(const REAL **in, REAL **out, pin::Convention convention)
{
    give_symmetric(out[0], pin::crba(model, data, vector(in[0]), convention));
    return 0;
}

static int forward_dynamics(const REAL **in, REAL **out, pin::Convention convention)
{
    give(out[0], pin::aba(model, data, vector(in[0]), vector(in[1]), vector(in[2]), convention));
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
