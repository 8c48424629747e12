// A function of a robot for many states on a GPU: one thread a state.
//
// In: a file of states (argument 1), how many to compute with (2; the file's are taken again and again), how often to
// (3). Out: one line: registers and bytes of local memory a thread; quartiles of the time a state in ps, on the GPU
// alone and with copies from and to the host's pinned memory; how many numbers of the file's states differ from what
// the host computes by the same source, and by how much of their largest at most.
//
// SOURCE is the file in C, FUNCTION a function of it, REAL its type of number, NQ the length of a configuration, NV that
// of arrays with an entry for each velocity: it takes q, q̇ and one more, and gives one. States stand coordinate by
// coordinate, so that neighbouring threads read neighbouring numbers.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#define HOMOGEN_FN __host__ __device__
#define HOMOGEN_FMA(a, b, c) fma(a, b, c)
#define HOMOGEN_FMAF(a, b, c) fmaf(a, b, c)
#include SOURCE

constexpr int THREADS = 128;

__global__ void __launch_bounds__(THREADS) many(const REAL *q, const REAL *qd, const REAL *x, REAL *y, size_t count)
{
    const size_t i = blockIdx.x * size_t(THREADS) + threadIdx.x;
    if (i >= count) return;
    REAL own_q[NQ], own_qd[NV], own_x[NV], own_y[NV];
    for (int k = 0; k < NQ; k++) own_q[k] = q[k * count + i];
    for (int k = 0; k < NV; k++) own_qd[k] = qd[k * count + i];
    for (int k = 0; k < NV; k++) own_x[k] = x[k * count + i];
    FUNCTION(own_q, own_qd, own_x, own_y);
    for (int k = 0; k < NV; k++) y[k * count + i] = own_y[k];
}

static void ok(cudaError_t status)
{
    if (status != cudaSuccess) {
        fprintf(stderr, "many: %s\n", cudaGetErrorString(status));
        exit(1);
    }
}

// The quartiles of times in ms, as ps a state.
static void print_quartiles(std::vector<float> times, size_t count)
{
    std::sort(times.begin(), times.end());
    for (size_t quarter = 1; quarter < 4; quarter++)
        printf(" %.3f", 1e9 * times[(times.size() - 1) * quarter / 4] / count);
}

int main(int, char **arguments)
{
    constexpr size_t LENGTH = NQ + 2 * NV;
    FILE *file = fopen(arguments[1], "rb");
    if (file == nullptr) return fprintf(stderr, "many: no file %s\n", arguments[1]), 1;
    std::vector<double> states;
    for (double state[LENGTH]; fread(state, sizeof state, 1, file) == 1;)
        states.insert(states.end(), state, state + LENGTH);
    fclose(file);
    const size_t given = states.size() / LENGTH;
    const size_t count = strtoull(arguments[2], nullptr, 10);
    const int rounds = atoi(arguments[3]);

    REAL *in, *out, *on_gpu;
    const size_t all = count * LENGTH;
    ok(cudaMallocHost(&in, all * sizeof(REAL)));
    ok(cudaMallocHost(&out, count * NV * sizeof(REAL)));
    ok(cudaMalloc(&on_gpu, (all + count * NV) * sizeof(REAL)));
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < LENGTH; k++) in[k * count + i] = REAL(states[i % given * LENGTH + k]);

    REAL *const results = on_gpu + all;
    const auto blocks = unsigned((count + THREADS - 1) / THREADS);
    const auto copy_in = [&] { ok(cudaMemcpyAsync(on_gpu, in, all * sizeof(REAL), cudaMemcpyHostToDevice)); };
    const auto compute = [&] {
        many<<<blocks, THREADS>>>(on_gpu, on_gpu + NQ * count, on_gpu + (NQ + NV) * count, results, count);
        ok(cudaGetLastError());
    };
    const auto copy_out = [&] { ok(cudaMemcpyAsync(out, results, count * NV * sizeof(REAL), cudaMemcpyDeviceToHost)); };
    cudaEvent_t begin, end;
    ok(cudaEventCreate(&begin));
    ok(cudaEventCreate(&end));
    const auto timed = [&](auto work) {
        std::vector<float> times(rounds);
        work();
        for (float &time : times) {
            ok(cudaEventRecord(begin));
            work();
            ok(cudaEventRecord(end));
            ok(cudaEventSynchronize(end));
            ok(cudaEventElapsedTime(&time, begin, end));
        }
        return times;
    };
    const auto with_copies = timed([&] { copy_in(), compute(), copy_out(); });
    const auto alone = timed(compute);

    size_t differing = 0;
    double worst = 0.0;
    for (size_t i = 0; i < std::min(given, count); i++) {
        REAL state[LENGTH], expected[NV];
        for (size_t k = 0; k < LENGTH; k++) state[k] = in[k * count + i];
        FUNCTION(state, state + NQ, state + NQ + NV, expected);
        double largest = 0.0, difference = 0.0;
        for (size_t k = 0; k < NV; k++) {
            const REAL here = out[k * count + i];
            differing += memcmp(&here, &expected[k], sizeof here) != 0;
            largest = std::max(largest, std::fabs(double(expected[k])));
            difference = std::max(difference, std::fabs(double(here) - double(expected[k])));
        }
        if (difference > 0.0) worst = std::max(worst, difference / largest);
    }
    cudaFuncAttributes attributes;
    ok(cudaFuncGetAttributes(&attributes, many));
    printf("%d %zu", attributes.numRegs, attributes.localSizeBytes);
    print_quartiles(alone, count);
    print_quartiles(with_copies, count);
    printf(" %zu %.3e\n", differing, worst);
    return 0;
}
