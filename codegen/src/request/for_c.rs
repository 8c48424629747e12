//! Options of files in C alone.
//!
//! In: the words of the command line. Out: what a file has beside the functions.

use crate::wording::known;

/// Parts of a file in C beside its functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ForC {
    /// `CasADi`'s external interface.
    pub casadi: bool,
    /// Time steps by this rule.
    pub steps: Option<Integrator>,
    /// Discrete dynamics of acados by these steps.
    pub acados: bool,
}

impl ForC {
    /// The key of the first part that is asked for.
    #[must_use]
    pub fn first(self) -> Option<&'static str> {
        let keys = [
            (self.casadi, "casadi"),
            (self.steps.is_some(), "steps"),
            (self.acados, "acados"),
        ];
        keys.into_iter()
            .find_map(|(asked, key)| asked.then_some(key))
    }

    /// The same if numbers need not be `f64`.
    #[must_use]
    pub fn first_of_f64(self) -> Option<&'static str> {
        Self {
            steps: None,
            ..self
        }
        .first()
    }
}

/// A rule of numerical integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Integrator {
    /// q̇⁺ = q̇ + Δt q̈, q⁺ = q + Δt q̇⁺.
    SemiImplicit,
    /// q̇⁺ = q̇ + Δt q̈, q⁺ = q + Δt q̇.
    Euler,
    /// The classical rule of Runge and Kutta, of order 4.
    Rk4,
    /// q̇⁺ = q̇ + Δt q̈, q⁺ = q + Δt w with w = (q̇ + q̇⁺)/2, and q̈ at q + Δt w/2 and w: an equation for q̇⁺.
    ImplicitMidpoint,
}

impl Integrator {
    /// All rules.
    pub const ALL: [Self; 4] = [
        Self::SemiImplicit,
        Self::Euler,
        Self::Rk4,
        Self::ImplicitMidpoint,
    ];

    /// Name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::SemiImplicit => "semi-implicit",
            Self::Euler => "euler",
            Self::Rk4 => "rk4",
            Self::ImplicitMidpoint => "implicit-midpoint",
        }
    }

    /// The rule with this name.
    ///
    /// # Errors
    /// For an unknown name: a hint that lists the known ones.
    pub fn from_name(name: &str) -> Result<Self, String> {
        let mut all = Self::ALL.into_iter();
        all.find(|rule| rule.name() == name)
            .ok_or_else(|| known(name, "rules", &Self::ALL.map(Self::name)))
    }
}
