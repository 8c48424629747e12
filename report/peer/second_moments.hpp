// A row of a regressor by homogen's inertial parameters of a body, of one by Pinocchio's.
//
// In: what a force has of m, m c, I_xx, I_xy, I_yy, I_xz, I_yz, I_zz, the moments of inertia about the
// origin of the body's frame. Out: what it has of m, m c, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz, where J is
// ∫PPᵗdm: I_xx = J_yy + J_zz and so on, I_xy = −J_xy.
#pragma once

#include <array>

template <typename Row>
auto by_second_moments(const Row &y)
{
    using Real = typename Row::Scalar;
    const Real xx = y[4], xy = y[5], yy = y[6], xz = y[7], yz = y[8], zz = y[9];
    return std::array<Real, 10>{y[0], y[1], y[2], y[3], Real(yy + zz), Real(-xy), Real(-xz),
        Real(xx + zz), Real(-yz), Real(xx + yy)};
}
