// The peer's C of derivatives, and of what else controllers and estimators ask for.
//
// In: a robot over symbols. Out: files as generate.cpp writes them, with which it is linked.

#include "generate.hpp"

#include "pinocchio/algorithm/aba-derivatives.hpp"
#include "pinocchio/algorithm/centroidal.hpp"
#include "pinocchio/algorithm/regressor.hpp"
#include "pinocchio/algorithm/rnea-derivatives.hpp"
#include "pinocchio/algorithm/rnea.hpp"

#include "second_moments.hpp"

namespace pin = pinocchio;

void write_derivatives(Writer &to)
{
    const SX q = to.q, qd = to.qd, x = to.x;
    const Vector eq = to.eq, eqd = to.eqd, ex = to.ex;
    const auto &model = to.model;
    // What was computed before is in the way: algorithms add to some of it.
    pinocchio::DataTpl<SX> data(model);

    pin::computeRNEADerivatives(model, data, eq, eqd, ex);
    std::vector<SX> out;
    Writer::append(out, data.dtau_dq);
    Writer::append(out, data.dtau_dv);
    to.write("inverse_dynamics_derivatives", {q, qd, x}, out);

    pin::computeABADerivatives(model, data, eq, eqd, ex);
    out.clear();
    Writer::append(out, data.ddq_dq);
    Writer::append(out, data.ddq_dv);
    const auto inverse = to.symmetric(data.Minv);
    out.insert(out.end(), inverse.begin(), inverse.end());
    to.write("forward_dynamics_derivatives", {q, qd, x}, out);

    pin::computeCoriolisMatrix(model, data, eq, eqd);
    out.clear();
    Writer::append(out, data.C);
    to.write("coriolis_matrix", {q, qd}, out);

    pin::computeJointTorqueRegressor(model, data, eq, eqd, ex);
    out.clear();
    const auto &rows = data.jointTorqueRegressor;
    for (int row = 0; row < rows.rows(); ++row)
        for (int body = 0; body < rows.cols(); body += 10)
            for (const SX &entry : by_second_moments(Vector(rows.row(row).segment(body, 10))))
                out.push_back(entry);
    to.write("regressor", {q, qd, x}, out);

    pin::computeCentroidalMap(model, data, eq);
    to.write("centroidal_momentum_matrix", {q}, to.columns(data.Ag));
}
