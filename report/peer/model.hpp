// A robot for Pinocchio from the numbers that model.py wrote.
//
// In: a stream of them, and whether residues of right angles below 1e-9 are to become exact. Out: a
// model with a frame "tip", whose joints come in the order of the numbers.
#pragma once

#include "pinocchio/multibody.hpp"
#include "pinocchio/multibody/joint.hpp"

#include <cmath>
#include <istream>
#include <string>

/* Numbers of a text, one after the other. */
struct Numbers {
    std::istream &text;
    bool snap;

    double next()
    {
        double number = NAN;
        text >> number;
        return number;
    }

    Eigen::Vector3d vector()
    {
        Eigen::Vector3d vector;
        for (double &entry : vector)
            entry = next();
        return vector;
    }

    pinocchio::SE3 placement()
    {
        pinocchio::SE3 placement;
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

    static double snapped(double value)
    {
        const double nearest = std::round(value);
        return std::abs(value - nearest) < 1e-9 ? nearest : value;
    }
};

/* What model.py calls a free base, what turns and what slides. */
enum Kind { FREE, TURNS, SLIDES };

/* The joint that Pinocchio's own reader makes of an axis: one for x, y or z where it is one of them. */
template <typename X, typename Y, typename Z, typename Unaligned>
pinocchio::JointModel joint_along(const Eigen::Vector3d &axis)
{
    if (axis == Eigen::Vector3d::UnitX())
        return X();
    if (axis == Eigen::Vector3d::UnitY())
        return Y();
    if (axis == Eigen::Vector3d::UnitZ())
        return Z();
    return Unaligned(axis);
}

inline pinocchio::JointModel joint_of(Kind kind, const Eigen::Vector3d &axis)
{
    namespace pin = pinocchio;
    switch (kind) {
    case FREE:
        return pin::JointModelFreeFlyer();
    case TURNS:
        return joint_along<pin::JointModelRX, pin::JointModelRY, pin::JointModelRZ,
            pin::JointModelRevoluteUnaligned>(axis);
    default:
        return joint_along<pin::JointModelPX, pin::JointModelPY, pin::JointModelPZ,
            pin::JointModelPrismaticUnaligned>(axis);
    }
}

inline pinocchio::Model robot_of(Numbers numbers)
{
    namespace pin = pinocchio;
    pin::Model robot;
    // Its default is a constant that may not be set yet where a robot is made before main.
    robot.gravity.linear() << 0, 0, -9.81;
    const int joints = int(numbers.next());
    for (int joint = 1; joint <= joints; ++joint) {
        const int carrier = int(numbers.next());
        const Kind kind = Kind(int(numbers.next()));
        const Eigen::Vector3d axis = numbers.vector();
        robot.addJoint(carrier, joint_of(kind, axis), numbers.placement(), std::to_string(joint));
        const double mass = numbers.next();
        const Eigen::Vector3d centre = numbers.vector();
        const Eigen::Vector3d first = numbers.vector(), second = numbers.vector();
        const pin::Symmetric3 inertia(first[0], first[1], first[2], second[0], second[1], second[2]);
        robot.appendBodyToJoint(joint, pin::Inertia(mass, centre, inertia), pin::SE3::Identity());
    }
    const int carrier = int(numbers.next());
    robot.addFrame(pin::Frame("tip", carrier, 0, numbers.placement(), pin::OP_FRAME));
    return robot;
}
