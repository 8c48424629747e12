/* Times a step with A and B: the generated functions, and CasADi's C of its own Jacobian. Macros: HEADER, STEP, the
 * name of the function, and COUNT, the number of velocities. Prints the medians in ns.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include HEADER

int by_casadi(const double **arg, double **res, long long *iw, double *w, int mem);
int by_casadi_work(long long *arg, long long *res, long long *iw, long long *w);

enum { N = COUNT, ROUNDS = 101, CALLS = 200 };

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

static int order(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(void)
{
    static double q[N], qd[N], tau[N], next[2 * N], a[2 * N][2 * N], b[2 * N][N], jacobian[6 * N * N], times[2][ROUNDS];
    double dt = 0.01;
    const double *arg[64] = {q, qd, tau, &dt};
    double *res[64] = {next, jacobian};
    long long sizes[4];
    int round, call, k;
    by_casadi_work(&sizes[0], &sizes[1], &sizes[2], &sizes[3]);
    long long *iw = malloc(sizeof *iw * (size_t)(sizes[2] + 1));
    double *w = malloc(sizeof *w * (size_t)(sizes[3] + 1));
    for (round = 0; round < ROUNDS; ++round) {
        for (k = 0; k < N; ++k) {
            q[k] = 3.0 * rand() / RAND_MAX - 1.5;
            qd[k] = 3.0 * rand() / RAND_MAX - 1.5;
            tau[k] = 20.0 * rand() / RAND_MAX - 10.0;
        }
        double start = now();
        for (call = 0; call < CALLS; ++call) {
            STEP(q, qd, tau, dt, next, next + N, a, b);
        }
        double middle = now();
        for (call = 0; call < CALLS; ++call) {
            by_casadi(arg, res, iw, w, 0);
        }
        times[0][round] = (middle - start) / CALLS;
        times[1][round] = (now() - middle) / CALLS;
    }
    for (k = 0; k < 2; ++k) {
        qsort(times[k], ROUNDS, sizeof times[k][0], order);
    }
    printf("%.0f %.0f\n", times[0][ROUNDS / 2], times[1][ROUNDS / 2]);
    return 0;
}
