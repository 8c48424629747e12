// An arm for Pinocchio from the numbers that model.py wrote.
//
// In: a stream of them, and whether residues of right angles below 1e-9 are to become exact. Out: a
// model with a frame "tip".
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

inline pinocchio::Model arm_of(Numbers numbers)
{
    namespace pin = pinocchio;
    pin::Model arm;
    // Its default is a constant that may not be set yet where an arm is made before main.
    arm.gravity.linear() << 0, 0, -9.81;
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
