//! Discrete dynamics of acados: the time steps of a robot by the interface of `dyn_ext_fun_type = 'generic'`.
//!
//! In: a [`Module`] whose file has time steps. Out: functions of vectors and matrices of BLASFEO, as acados calls them
//! (`ocp_nlp_dynamics_disc.c`, August 2026): x = (q, q̇), u = τ; the next state, its transposed Jacobian by (u, x), and
//! the Hessian of its product with the multipliers π by (u, x).

use super::comments::comment;
use super::names::{own, symbols};
use crate::function::Function;
use crate::module::Module;
use crate::space::Space;

/// Text of the interface.
pub(super) fn interface(module: &Module, prefix: &str) -> String {
    let n = module.spaces.len(Space::Velocities);
    let (double, triple) = (2 * n, 3 * n);
    let name = |name: &str| own(prefix, name);
    let has_hessian = symbols(module, prefix)
        .iter()
        .any(|symbol| *symbol == name(Function::ForwardDynamicsHessian.name()));
    let [fun, jac, hess] = ["acados_fun", "acados_fun_jac", "acados_fun_jac_hess"].map(name);
    let [step, derivatives, second] = ["step", "step_derivatives", "step_hessian"].map(name);
    let about = [
        "Discrete dynamics of acados: dyn_ext_fun_type = 'generic', with dyn_disc_fun, dyn_disc_fun_jac and",
        "dyn_disc_fun_jac_hess. x is q and qd, u is tau; the first parameter is the duration of a step [s].",
    ];
    let about = comment(&about.map(str::to_owned));
    let inputs = format!(
        "    const struct blasfeo_dvec_args *x = (const struct blasfeo_dvec_args *)in[0];
    const struct blasfeo_dvec_args *u = (const struct blasfeo_dvec_args *)in[1];
    const double dt = *(const double *)params;
    double q[{n}], qd[{n}], tau[{n}];
    int r, c;
    for (r = 0; r < {n}; ++r) {{
        q[r] = BLASFEO_DVECEL(x->x, x->xi + r);
        qd[r] = BLASFEO_DVECEL(x->x, x->xi + {n} + r);
        tau[r] = BLASFEO_DVECEL(u->x, u->xi + r);
    }}
"
    );
    let value = format!(
        "    {{
        const struct blasfeo_dvec_args *next = (const struct blasfeo_dvec_args *)out[0];
        double next_q[{n}], next_qd[{n}];
        {step}(q, qd, tau, dt, next_q, next_qd);
        for (r = 0; r < {n}; ++r) {{
            BLASFEO_DVECEL(next->x, next->xi + r) = next_q[r];
            BLASFEO_DVECEL(next->x, next->xi + {n} + r) = next_qd[r];
        }}
    }}
"
    );
    let jacobian = format!(
        "    {{
        const struct blasfeo_dmat_args *jac = (const struct blasfeo_dmat_args *)out[1];
        double a[{double}][{double}], b[{double}][{n}];
        {derivatives}(q, qd, tau, dt, a, b);
        for (c = 0; c < {double}; ++c) {{
            for (r = 0; r < {triple}; ++r) {{
                BLASFEO_DMATEL(jac->A, jac->ai + r, jac->aj + c) = r < {n} ? b[c][r] : a[c][r - {n}];
            }}
        }}
    }}
"
    );
    let hessian = format!(
        "    {{
        const struct blasfeo_dvec_args *pi = (const struct blasfeo_dvec_args *)in[2];
        const struct blasfeo_dmat_args *hess = (const struct blasfeo_dmat_args *)out[2];
        double weights[{double}], of_state_first[{triple}][{triple}];
        for (r = 0; r < {double}; ++r) {{
            weights[r] = BLASFEO_DVECEL(pi->x, pi->xi + r);
        }}
        {second}(q, qd, tau, dt, weights, of_state_first);
        for (r = 0; r < {triple}; ++r) {{
            for (c = 0; c < {triple}; ++c) {{
                BLASFEO_DMATEL(hess->A, hess->ai + r, hess->aj + c) =
                    of_state_first[(r + {double}) % {triple}][(c + {double}) % {triple}];
            }}
        }}
    }}
"
    );
    let function = |name: &str, parts: &[&str], unused: &str| {
        format!(
            "
int {name}(void **in, void **out, void *params)
{{
{inputs}{}{unused}    return 0;
}}
",
            parts.concat()
        )
    };
    let mut text = format!(
        "
{about}#include \"acados/utils/external_function_generic.h\"
#include \"blasfeo_common.h\"

#ifdef __cplusplus
extern \"C\" {{
#endif

int {fun}(void **in, void **out, void *params);
int {jac}(void **in, void **out, void *params);
"
    );
    if has_hessian {
        text.push_str(&format!(
            "int {hess}(void **in, void **out, void *params);\n"
        ));
    }
    text.push_str(&function(&fun, &[&value], "    (void)c;\n"));
    text.push_str(&function(&jac, &[&value, &jacobian], ""));
    if has_hessian {
        text.push_str(&function(&hess, &[&value, &jacobian, &hessian], ""));
    }
    text + "
#ifdef __cplusplus
}
#endif
"
}
