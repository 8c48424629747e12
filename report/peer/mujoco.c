/* MuJoCo's inverse dynamics behind a function of CasADi's signature.
 *
 * In: where it is linked, the text `peer_robot`, which mjcf.py wrote. Out: peer_inverse_dynamics, with the
 * coordinates that Pinocchio has; and peer_reads, which tells whether MuJoCo takes the robot. A copy of the
 * library serves one thread. */

#include <mujoco/mujoco.h>

#include <stdio.h>
#include <string.h>

extern const char peer_robot[];

static mjModel *model;
static mjData *data;

__attribute__((constructor)) static void read_robot(void)
{
    char error[1000] = "";
    mjVFS files;
    mj_defaultVFS(&files);
    mj_addBufferVFS(&files, "robot.xml", peer_robot, (int)strlen(peer_robot));
    model = mj_loadXML("robot.xml", &files, error, sizeof error);
    mj_deleteVFS(&files);
    if (model)
        data = mj_makeData(model);
    else
        fprintf(stderr, "MuJoCo: %s\n", error);
}

int peer_reads(void)
{
    return data != NULL;
}

int peer_inverse_dynamics(const double **in, double **out, long long *w, double *work, int memory)
{
    (void)w, (void)work, (void)memory;
    const double *q = in[0], *qd = in[1], *qdd = in[2];
    const size_t size = (size_t)model->nv * sizeof *q;
    const int is_free = model->nq > model->nv;
    memcpy(data->qpos, q, (size_t)model->nq * sizeof *q);
    memcpy(data->qvel, qd, size);
    memcpy(data->qacc, qdd, size);
    if (is_free) {
        /* w comes first, and linear velocities are those of the world, whose rates are accelerations. */
        const double turn[4] = {q[6], q[3], q[4], q[5]};
        const double rate[3] = {
            qdd[0] + qd[4] * qd[2] - qd[5] * qd[1],
            qdd[1] + qd[5] * qd[0] - qd[3] * qd[2],
            qdd[2] + qd[3] * qd[1] - qd[4] * qd[0],
        };
        memcpy(data->qpos + 3, turn, sizeof turn);
        mju_rotVecQuat(data->qvel, qd, turn);
        mju_rotVecQuat(data->qacc, rate, turn);
    }
    mj_inverse(model, data);
    memcpy(out[0], data->qfrc_inverse, size);
    if (is_free) {
        double back[4];
        mju_negQuat(back, data->qpos + 3);
        mju_rotVecQuat(out[0], data->qfrc_inverse, back);
    }
    return 0;
}
