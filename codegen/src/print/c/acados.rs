//! Discrete dynamics of acados: the time steps of a robot by the interface of `dyn_ext_fun_type = 'generic'`.
//!
//! In: a [`Module`] whose file has time steps. Out: functions of vectors and matrices of BLASFEO, as acados calls them
//! (`ocp_nlp_dynamics_disc.c`, August 2026): x = (q, q̇), u = τ; the next state, its transposed Jacobian by (u, x), and
//! the Hessian of its product with the multipliers π by (u, x).

use super::comments::comment;
use super::names::own;
use super::steps;
use crate::module::Module;
use crate::space::Space;

/// Text of the interface.
pub(super) fn interface(module: &Module, prefix: &str) -> String {
    let n = module.spaces.len(Space::Velocities);
    let (double, triple) = (2 * n, 3 * n);
    let name = |name: &str| own(prefix, name);
    let [fun, jac, hess] = ["acados_fun", "acados_fun_jac", "acados_fun_jac_hess"].map(name);
    let [step, derivatives] = ["step", "step_derivatives"].map(name);
    let [read, store] = ["acados_read", "acados_store"].map(name);
    let about = [
        "Discrete dynamics of acados: dyn_ext_fun_type = 'generic', with dyn_disc_fun, dyn_disc_fun_jac and",
        "dyn_disc_fun_jac_hess. x is q and qd, u is tau; the first parameter is the duration of a step [s].",
    ];
    let about = comment(&about.map(str::to_owned));
    let has_hessian = steps::has_hessian(module);
    let declared = if has_hessian {
        format!("int {hess}(void **in, void **out, void *params);\n")
    } else {
        String::new()
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
{declared}
static void {read}(void **in, double q[{n}], double qd[{n}], double tau[{n}])
{{
    const struct blasfeo_dvec_args *x = (const struct blasfeo_dvec_args *)in[0];
    const struct blasfeo_dvec_args *u = (const struct blasfeo_dvec_args *)in[1];
    int k;
    for (k = 0; k < {n}; ++k) {{
        q[k] = BLASFEO_DVECEL(x->x, x->xi + k);
        qd[k] = BLASFEO_DVECEL(x->x, x->xi + {n} + k);
        tau[k] = BLASFEO_DVECEL(u->x, u->xi + k);
    }}
}}

static void {store}(void **out, const double q[{n}], const double qd[{n}])
{{
    const struct blasfeo_dvec_args *next = (const struct blasfeo_dvec_args *)out[0];
    int k;
    for (k = 0; k < {n}; ++k) {{
        BLASFEO_DVECEL(next->x, next->xi + k) = q[k];
        BLASFEO_DVECEL(next->x, next->xi + {n} + k) = qd[k];
    }}
}}

int {fun}(void **in, void **out, void *params)
{{
    double q[{n}], qd[{n}], tau[{n}], next_q[{n}], next_qd[{n}];
    {read}(in, q, qd, tau);
    {step}(q, qd, tau, *(const double *)params, next_q, next_qd);
    {store}(out, next_q, next_qd);
    return 0;
}}

int {jac}(void **in, void **out, void *params)
{{
    const struct blasfeo_dmat_args *jac = (const struct blasfeo_dmat_args *)out[1];
    double q[{n}], qd[{n}], tau[{n}], next_q[{n}], next_qd[{n}];
    double a[{double}][{double}], b[{double}][{n}];
    int r, c;
    {read}(in, q, qd, tau);
    {derivatives}(q, qd, tau, *(const double *)params, next_q, next_qd, a, b);
    {store}(out, next_q, next_qd);
    for (c = 0; c < {double}; ++c) {{
        for (r = 0; r < {triple}; ++r) {{
            BLASFEO_DMATEL(jac->A, jac->ai + r, jac->aj + c) = r < {n} ? b[c][r] : a[c][r - {n}];
        }}
    }}
    return 0;
}}
"
    );
    if has_hessian {
        text.push_str(&with_hessian(n, prefix));
    }
    text + "
#ifdef __cplusplus
}
#endif
"
}

/// The function with the Hessian.
fn with_hessian(n: usize, prefix: &str) -> String {
    let (double, triple) = (2 * n, 3 * n);
    let name = |name: &str| own(prefix, name);
    let [jac, hess, read, second] = [
        "acados_fun_jac",
        "acados_fun_jac_hess",
        "acados_read",
        "step_hessian",
    ]
    .map(name);
    format!(
        "
int {hess}(void **in, void **out, void *params)
{{
    const struct blasfeo_dvec_args *pi = (const struct blasfeo_dvec_args *)in[2];
    const struct blasfeo_dmat_args *hess = (const struct blasfeo_dmat_args *)out[2];
    double q[{n}], qd[{n}], tau[{n}], weights[{double}], of_state_first[{triple}][{triple}];
    int r, c;
    {read}(in, q, qd, tau);
    for (r = 0; r < {double}; ++r) {{
        weights[r] = BLASFEO_DVECEL(pi->x, pi->xi + r);
    }}
    {second}(q, qd, tau, *(const double *)params, weights, of_state_first);
    for (r = 0; r < {triple}; ++r) {{
        for (c = 0; c < {triple}; ++c) {{
            BLASFEO_DMATEL(hess->A, hess->ai + r, hess->aj + c) =
                of_state_first[(r + {double}) % {triple}][(c + {double}) % {triple}];
        }}
    }}
    return {jac}(in, out, params);
}}
"
    )
}
