// What Pinocchio's functions are called with, and where they leave results.
//
// In: REAL, the type of number; where it is linked, the text `peer_model`, which model.py wrote. Out:
// the robot, its data, and PEER, which makes a function of CasADi's signature that others can load.
// Each file that includes it has its own robot.
#pragma once

#include "pinocchio/algorithm/frames.hpp"

#include "model.hpp"

#include <algorithm>
#include <sstream>

namespace pin = pinocchio;
using Vector = Eigen::Map<const Eigen::Matrix<REAL, Eigen::Dynamic, 1>>;

extern "C" const char peer_model[];

static pin::ModelTpl<REAL> read()
{
    std::istringstream text(peer_model);
    return robot_of({text, false}).cast<REAL>();
}

static const pin::ModelTpl<REAL> model = read();
static pin::DataTpl<REAL> data(model);
static const pin::FrameIndex tip = model.getFrameId("tip");

static Vector coordinates(const REAL *numbers)
{
    return Vector(numbers, model.nq);
}

static Vector velocities(const REAL *numbers)
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
