/* Compares time steps and acados' functions of a robot with the rules written out, and with differences.
 *
 * Macros: HEADER, ROBOT, RULE and COUNT, the number of velocities. Prints the largest differences; the exit status is a failure if one is too large.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "acados/utils/external_function_generic.h"
#include "blasfeo_common.h"
#include "blasfeo_d_aux_ext_dep.h"
#include HEADER

#define JOINED(a, b) a##b
#define PASTED(a, b) JOINED(a, b)
#define OF(name) PASTED(ROBOT, _##name)
#define TEXT_OF(text) #text
#define TEXT(text) TEXT_OF(text)

int OF(acados_fun)(void **in, void **out, void *params);
int OF(acados_fun_jac)(void **in, void **out, void *params);
int OF(acados_fun_jac_hess)(void **in, void **out, void *params);

/* As acados holds them. */
typedef int (*generic)(void **in, void **out, void *params);

enum { N = COUNT, X = 2 * N, Z = 3 * N };

static double drawn(void)
{
    return 2.0 * rand() / RAND_MAX - 1.0;
}

/* z is q, qd and tau. */
static void rule(const double *z, double dt, double *next)
{
    const double *tau = z + X;
    double k[4][N], v[4][N], at[N];
    int i;
    const char *name = TEXT(RULE);
    OF(forward_dynamics)(z, z + N, tau, k[0]);
    for (i = 0; i < N; ++i) {
        v[0][i] = z[N + i];
        v[1][i] = z[N + i] + dt / 2 * k[0][i];
        at[i] = z[i] + dt / 2 * v[0][i];
        next[N + i] = z[N + i] + dt * k[0][i];
        next[i] = z[i] + dt * (strcmp(name, "euler") ? next[N + i] : z[N + i]);
    }
    if (strcmp(name, "rk4")) {
        return;
    }
    OF(forward_dynamics)(at, v[1], tau, k[1]);
    for (i = 0; i < N; ++i) {
        v[2][i] = z[N + i] + dt / 2 * k[1][i];
        at[i] = z[i] + dt / 2 * v[1][i];
    }
    OF(forward_dynamics)(at, v[2], tau, k[2]);
    for (i = 0; i < N; ++i) {
        v[3][i] = z[N + i] + dt * k[2][i];
        at[i] = z[i] + dt * v[2][i];
    }
    OF(forward_dynamics)(at, v[3], tau, k[3]);
    for (i = 0; i < N; ++i) {
        next[i] = z[i] + dt / 6 * (v[0][i] + 2 * v[1][i] + 2 * v[2][i] + v[3][i]);
        next[N + i] = z[N + i] + dt / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
    }
}

/* The gradient of the sum of the next state times weights. */
static void gradient(const double *z, double dt, const double *weights, double *found)
{
    static double a[X][X], b[X][N];
    double next[X];
    int r, c;
    OF(step_derivatives)(z, z + N, z + X, dt, next, next + N, a, b);
    for (c = 0; c < Z; ++c) {
        found[c] = 0;
        for (r = 0; r < X; ++r) {
            found[c] += weights[r] * (c < X ? a[r][c] : b[r][c - X]);
        }
    }
}

/* A column of differences of order 4 of the rule, or of the gradient. */
static void differences(const double *z, double dt, const double *weights, int c, int count, double *column)
{
    const double h = 3e-4, share[4] = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
    const int place[4] = {-2, -1, 1, 2};
    double moved[Z], value[Z];
    int k, r;
    for (r = 0; r < count; ++r) {
        column[r] = 0;
    }
    for (k = 0; k < 4; ++k) {
        memcpy(moved, z, sizeof moved);
        moved[c] += place[k] * h;
        if (weights) {
            gradient(moved, dt, weights, value);
        } else {
            rule(moved, dt, value);
        }
        for (r = 0; r < count; ++r) {
            column[r] += share[k] / h * value[r];
        }
    }
}

static double larger(double a, double b)
{
    return fabs(b) > a ? fabs(b) : a;
}

int main(void)
{
    double worst[3] = {0, 0, 0};
    int trial, r, c;
    struct blasfeo_dvec x, u, pi, next;
    struct blasfeo_dmat jac, hess;
    /* Places that are not at the beginning, as in the large matrices of a solver. */
    struct blasfeo_dvec_args x_in = {&x, 1}, u_in = {&u, 2}, pi_in = {&pi, 0}, next_out = {&next, 3};
    struct blasfeo_dmat_args jac_out = {&jac, 1, 2}, hess_out = {&hess, 3, 1};
    void *in[3] = {&x_in, &u_in, &pi_in}, *out[3] = {&next_out, &jac_out, &hess_out};
    blasfeo_allocate_dvec(X + 1, &x);
    blasfeo_allocate_dvec(N + 2, &u);
    blasfeo_allocate_dvec(X, &pi);
    blasfeo_allocate_dvec(X + 3, &next);
    blasfeo_allocate_dmat(Z + 1, X + 2, &jac);
    blasfeo_allocate_dmat(Z + 3, Z + 1, &hess);
    for (trial = 0; trial < 20; ++trial) {
        const generic functions[3] = {OF(acados_fun), OF(acados_fun_jac), OF(acados_fun_jac_hess)};
        double z[Z], weights[X], expected[Z], size, dt = 0.01 + 0.005 * drawn();
        for (r = 0; r < Z; ++r) {
            z[r] = (r < X ? 1.5 : 10.0) * drawn();
        }
        for (r = 0; r < X; ++r) {
            weights[r] = drawn();
            BLASFEO_DVECEL(&x, 1 + r) = z[r];
            BLASFEO_DVECEL(&pi, r) = weights[r];
        }
        for (r = 0; r < N; ++r) {
            BLASFEO_DVECEL(&u, 2 + r) = z[X + r];
        }
        rule(z, dt, expected);
        for (c = 0; c < 3; ++c) {
            for (r = 0; r < X; ++r) {
                BLASFEO_DVECEL(&next, 3 + r) = NAN;
            }
            if (functions[c](in, out, &dt)) {
                return 2;
            }
            for (r = 0; r < X; ++r) {
                worst[0] = larger(worst[0], BLASFEO_DVECEL(&next, 3 + r) - expected[r]);
            }
        }
        /* Rows of acados are u before x. */
        for (c = 0; c < Z; ++c) {
            const int row = c < X ? N + c : c - X;
            differences(z, dt, NULL, c, X, expected);
            for (size = 1, r = 0; r < X; ++r) {
                size = larger(size, expected[r]);
            }
            for (r = 0; r < X; ++r) {
                worst[1] = larger(worst[1], (BLASFEO_DMATEL(&jac, 1 + row, 2 + r) - expected[r]) / size);
            }
            differences(z, dt, weights, c, Z, expected);
            for (size = 1, r = 0; r < Z; ++r) {
                size = larger(size, expected[r]);
            }
            for (r = 0; r < Z; ++r) {
                const int column = r < X ? N + r : r - X;
                worst[2] = larger(worst[2], (BLASFEO_DMATEL(&hess, 3 + row, 1 + column) - expected[r]) / size);
            }
        }
    }
    printf("step %.1e, derivatives %.1e, Hessian %.1e\n", worst[0], worst[1], worst[2]);
    return !(worst[0] < 1e-12 && worst[1] < 1e-9 && worst[2] < 1e-9);
}
