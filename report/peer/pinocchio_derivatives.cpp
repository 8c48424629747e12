// The peer's derivatives, and what else controllers and estimators ask of it, behind C functions.
//
// In: what pinocchio.hpp says. Out: as pinocchio.cpp has it.

#include "pinocchio/algorithm/aba-derivatives.hpp"
#include "pinocchio/algorithm/centroidal.hpp"
#include "pinocchio/algorithm/regressor.hpp"
#include "pinocchio/algorithm/rnea-derivatives.hpp"
#include "pinocchio/algorithm/rnea.hpp"

#include "pinocchio.hpp"
#include "second_moments.hpp"

/* A matrix by rows; where the next one goes. */
template <typename Matrix>
static REAL *give_rows(REAL *place, const Matrix &matrix)
{
    if (place)
        for (int row = 0; row < matrix.rows(); ++row)
            for (int column = 0; column < matrix.cols(); ++column)
                *place++ = matrix(row, column);
    return place;
}

PEER(inverse_dynamics_derivatives)
{
    const auto q = coordinates(in[0]), qd = velocities(in[1]), qdd = velocities(in[2]);
    pin::computeRNEADerivatives(model, data, q, qd, qdd);
    give_rows(give_rows(out[0], data.dtau_dq), data.dtau_dv);
    return 0;
}

PEER(forward_dynamics_derivatives)
{
    const auto q = coordinates(in[0]), qd = velocities(in[1]), tau = velocities(in[2]);
    pin::computeABADerivatives(model, data, q, qd, tau);
    give_rows(give_rows(give_rows(out[0], data.ddq_dq), data.ddq_dv), data.Minv);
    return 0;
}

PEER(coriolis_matrix)
{
    give_rows(out[0], pin::computeCoriolisMatrix(model, data, coordinates(in[0]), velocities(in[1])));
    return 0;
}

PEER(regressor)
{
    const auto q = coordinates(in[0]), qd = velocities(in[1]), qdd = velocities(in[2]);
    const auto &rows = pin::computeJointTorqueRegressor(model, data, q, qd, qdd);
    if (REAL *place = out[0])
        for (int row = 0; row < rows.rows(); ++row)
            for (int body = 0; body < rows.cols(); body += 10)
                for (const REAL entry : by_second_moments(rows.row(row).segment(body, 10).eval()))
                    *place++ = entry;
    return 0;
}

// A momentum for each velocity; Pinocchio's rows are linear, then angular.
PEER(centroidal_momentum_matrix)
{
    const auto &momenta = pin::computeCentroidalMap(model, data, coordinates(in[0]));
    if (REAL *place = out[0])
        for (int column = 0; column < model.nv; ++column)
            for (int row : {3, 4, 5, 0, 1, 2})
                *place++ = momenta(row, column);
    return 0;
}
