/* A firmware in C that calls the arm's functions.
 *
 * In: arm.h, which the build script of this folder writes, and states.h, which `host states` does.
 * Out: over semihosting the bits of every result, in the lines of ../expected, for run.sh to
 * compare. */

#include <stdint.h>

#include "arm.h"
#include "board.h"
#include "states.h"

/* Every shape of a result. */
union result {
    float pose[3][4];
    float screws[JOINTS][6];
    float vector[JOINTS];
    float matrix[JOINTS][JOINTS];
    uint32_t bits[6 * JOINTS];
};

static void forward_kinematics(const struct state *s, union result *r)
{
    arm_forward_kinematics(s->q, r->pose);
}

static void geometric_jacobian(const struct state *s, union result *r)
{
    arm_geometric_jacobian(s->q, r->screws);
}

static void gravity(const struct state *s, union result *r)
{
    arm_gravity(s->q, r->vector);
}

static void inverse_dynamics(const struct state *s, union result *r)
{
    arm_inverse_dynamics(s->q, s->qd, s->qdd, r->vector);
}

static void mass_matrix(const struct state *s, union result *r)
{
    arm_mass_matrix(s->q, r->matrix);
}

static void forward_dynamics(const struct state *s, union result *r)
{
    arm_forward_dynamics(s->q, s->qd, s->tau, r->vector);
}

static const struct {
    const char *name;
    int length;
    void (*call)(const struct state *, union result *);
} functions[] = {
    {"FORWARD_KINEMATICS", 12, forward_kinematics},
    {"GEOMETRIC_JACOBIAN", 6 * JOINTS, geometric_jacobian},
    {"GRAVITY", JOINTS, gravity},
    {"INVERSE_DYNAMICS", JOINTS, inverse_dynamics},
    {"MASS_MATRIX", JOINTS * JOINTS, mass_matrix},
    {"FORWARD_DYNAMICS", JOINTS, forward_dynamics},
};

/* A word as 0x0123abcd; one pattern for every NaN, because the patterns of processors differ. */
static void print_bits(uint32_t bits)
{
    char word[] = "0x00000000";
    if ((bits & 0x7fffffff) > 0x7f800000)
        bits = 0x7fc00000;
    for (int place = 0; place < 8; place++)
        word[9 - place] = "0123456789abcdef"[bits >> 4 * place & 15];
    print(word);
}

int main(void)
{
    for (unsigned f = 0; f < sizeof functions / sizeof *functions; f++) {
        print(functions[f].name);
        print("\n");
        for (int i = 0; i < STATES; i++) {
            union result result;
            functions[f].call(&states[i].state, &result);
            print("    [");
            for (int k = 0; k < functions[f].length; k++) {
                print(k == 0 ? "" : ", ");
                print_bits(result.bits[k]);
            }
            print("],\n");
        }
    }
    return 0;
}
