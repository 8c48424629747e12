//! The entries of the results of generated functions.
//!
//! In: an array, a matrix, one of the typed matrices or a struct of several. Out: its numbers, row by row, in `f64`.

use homogen::{
    Acceleration, AccelerationChange, AccelerationDerivatives, AccelerationGradient,
    AccelerationHessian, Action, Momentum, Point, Pose, Real, Screw, TorqueChange,
    TorqueDerivatives, TorqueGradient, TorqueHessian, Velocity,
};

/// The numbers of a result, row by row.
pub trait Entries {
    /// Adds them to `numbers`.
    fn push(&self, numbers: &mut Vec<f64>);
}

impl Entries for f64 {
    fn push(&self, numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

impl Entries for f32 {
    fn push(&self, numbers: &mut Vec<f64>) {
        numbers.push(f64::from(*self));
    }
}

impl<X: Entries, const N: usize> Entries for [X; N] {
    fn push(&self, numbers: &mut Vec<f64>) {
        for entry in self {
            entry.push(numbers);
        }
    }
}

impl<T: Real + Entries> Entries for Pose<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.to_matrix().push(numbers);
    }
}

impl<T: Real + Entries> Entries for Screw<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        [self.u(), self.b()].push(numbers);
    }
}

impl<T: Real + Entries> Entries for Velocity<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        [self.omega(), self.v()].push(numbers);
    }
}

impl<T: Real + Entries> Entries for Point<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.0.push(numbers);
    }
}

impl<T: Real + Entries> Entries for Momentum<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        [self.gamma(), self.rho()].push(numbers);
    }
}

impl<T: Real + Entries> Entries for Action<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        [self.c(), self.f()].push(numbers);
    }
}

impl<T: Real + Entries> Entries for Acceleration<T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.to_matrix().push(numbers);
    }
}

impl<T: Entries, const N: usize> Entries for TorqueDerivatives<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.dq.push(numbers);
        self.dqd.push(numbers);
    }
}

impl<T: Entries, const N: usize> Entries for TorqueGradient<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        for part in [&self.dq, &self.dqd, &self.dqdd] {
            part.push(numbers);
        }
    }
}

impl<T: Entries, const N: usize> Entries for TorqueChange<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.value.push(numbers);
        self.change.push(numbers);
    }
}

impl<T: Entries, const N: usize> Entries for AccelerationChange<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.value.push(numbers);
        self.change.push(numbers);
    }
}

impl<T: Entries, const N: usize> Entries for AccelerationGradient<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        for part in [&self.dq, &self.dqd, &self.dtau] {
            part.push(numbers);
        }
    }
}

impl<T: Entries, const N: usize> Entries for AccelerationHessian<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        for block in [&self.dq_dq, &self.dq_dqd, &self.dqd_dqd, &self.dq_dtau] {
            block.push(numbers);
        }
    }
}

impl<T: Entries, const N: usize> Entries for TorqueHessian<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        for block in [&self.dq_dq, &self.dq_dqd, &self.dqd_dqd, &self.dq_dqdd] {
            block.push(numbers);
        }
    }
}

impl<T: Entries, const N: usize> Entries for AccelerationDerivatives<N, T> {
    fn push(&self, numbers: &mut Vec<f64>) {
        self.dq.push(numbers);
        self.dqd.push(numbers);
        self.dtau.push(numbers);
    }
}
