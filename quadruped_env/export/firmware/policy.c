#include "policy.h"

#include <math.h>

/* tables */

/* NaN stays NaN. */
static float clip(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

static float approached(float from, float to, float largest)
{
    return from + clip(to - from, -largest, largest);
}

/* Columns of the observation from `at` on; returns the next one. */
static int put(float *observation, int at, const float *values, int count)
{
    for (int i = 0; i < count; i++, at++)
        observation[at] = clip((values[i] - offset[at]) * scale[at], -bound[at], bound[at]);
    return at;
}

static float activate(float x)
{
    return ACTIVATE;
}

static void dense(const struct layer *layer, const float *in, float *out)
{
    const float *weight = layer->weight;
    for (int o = 0; o < layer->outputs; o++, weight += layer->inputs) {
        float sum = 0.0f;
        for (int i = 0; i < layer->inputs; i++)
            sum += weight[i] * in[i];
        out[o] = layer->bias[o] + sum;
    }
}

#ifdef OBSERVES_CLOCK
/* Sine and cosine of the phase, 0 where standing is commanded. */
static int put_clock(float *observation, int at, const policy_memory *memory)
{
    const float *command = memory->command;
    int moving = /* moves */;
    float clock[2] = {moving ? sinf(memory->gait_phase) : 0.0f, moving ? cosf(memory->gait_phase) : 0.0f};
    return put(observation, at, clock, 2);
}
#endif

/* observe */

#ifdef GAIT_KNOTS
/* Interval of increasing knots in which x lies, or the first or last one, and the fraction of it below x. */
static float locate(const float *knots, int count, float x, int *interval)
{
    int i = 0;
    while (i < count - 2 && x > knots[i + 1])
        i++;
    *interval = i;
    return clip((x - knots[i]) / (knots[i + 1] - knots[i]), 0.0f, 1.0f);
}

/* Part of the scripted gait's table (sine, cosine or offset; straight, turn or side) at a speed, rad. */
static float wave(int table, int interval, float part, int joint)
{
    const float *below = gait_waves + (table * GAIT_KNOTS + interval) * POLICY_JOINTS + joint;
    return below[0] + part * (below[POLICY_JOINTS] - below[0]);
}

/* Joint positions of the scripted gait; it fades into the stance towards a command of zero. */
static void scripted_gait(const float command[POLICY_COMMANDS], float phase, float joint_position[POLICY_JOINTS])
{
    float forward = fabsf(command[0]) / WHOLE_STEPS_FORWARD, turning = fabsf(command[1]) / WHOLE_STEPS_TURNING;
    float fade = clip(forward > turning ? forward : turning, 0.0f, 1.0f);/* fade sideways */
    float size = /* turn size */;
    float side = command[1] < 0.0f ? -size : size;
    int interval;
    float part = locate(gait_speeds, GAIT_KNOTS, command[0], &interval);
    for (int j = 0; j < POLICY_JOINTS; j++) {
        float whole[3];
        for (int k = 0; k < 3; k++)
            whole[k] = wave(k, interval, part, j) + size * wave(3 + k, interval, part, j)
                + side * wave(6 + k, interval, part, j)/* wave sideways */;
        float angle = phase + joint_phases[j];
        float swing = whole[0] * sinf(angle) + whole[1] * cosf(angle);
        joint_position[j] = policy_stance[j] + fade * (swing + whole[2] - policy_stance[j]);
    }
}
#endif

void policy_reset(policy_memory *memory)
{
    static const policy_memory zero;
    *memory = zero;
#if POLICY_HISTORY > 0
    for (int i = 0; i < POLICY_HISTORY; i++)
        memory->observation_history[i] = NAN;
#endif
}

void policy_graph(const policy_readings *readings, policy_memory *memory, float joint_target[POLICY_JOINTS])
{
    float one[WIDEST], other[WIDEST], *in = one, *out = other;
    observe(readings, memory, in);
#if POLICY_HISTORY > 0
    for (int i = 0; i < POLICY_HISTORY; i++) {
        float past = memory->observation_history[i];
        in[PRESENT + i] = isnan(past) ? in[i % PRESENT] : past;
    }
    for (int i = 0; i < POLICY_HISTORY; i++)
        memory->observation_history[i] = in[i];
#endif
    for (int l = 0; l < LAYERS; l++) {
        dense(&layers[l], in, out);
        for (int o = 0; o < layers[l].outputs && l < LAYERS - 1; o++)
            out[o] = activate(out[o]);
        float *swap = in;
        in = out;
        out = swap;
    }
    for (int j = 0; j < POLICY_JOINTS; j++)
        memory->last_action[j] = BOUNDED(in[j]);
#ifdef PHASE_STEP
    memory->gait_phase = fmodf(memory->gait_phase + PHASE_STEP, TURN);
#endif
#ifdef GAIT_KNOTS
    float nominal[POLICY_JOINTS];
    scripted_gait(memory->command, memory->gait_phase, nominal);
#else
    const float *nominal = policy_stance;
#endif
    for (int j = 0; j < POLICY_JOINTS; j++)
        joint_target[j] = clip(nominal[j] + ACTION_SCALE * memory->last_action[j], policy_lower[j], policy_upper[j]);
}

int policy_step(const policy_readings *readings, const float requested[POLICY_COMMANDS], policy_memory *memory,
                float joint_target[POLICY_JOINTS])
{
    policy_memory next = *memory;
    float target[POLICY_JOINTS];
    for (int i = 0; i < POLICY_COMMANDS; i++)
        next.command[i] = approached(memory->command[i], clip(requested[i], policy_command_low[i],
                                     policy_command_high[i]), policy_command_rate[i] * POLICY_TIMESTEP);
    policy_graph(readings, &next, target);
    for (int j = 0; j < POLICY_JOINTS; j++)
        if (!isfinite(target[j]))
            return 0;
    for (int j = 0; j < POLICY_JOINTS; j++)
        joint_target[j] = target[j];
    *memory = next;
    return 1;
}

int policy_approach(const float target[POLICY_JOINTS], float speed, float joint_position[POLICY_JOINTS])
{
    int there = 1;
    for (int j = 0; j < POLICY_JOINTS; j++) {
        float within = clip(target[j], policy_lower[j], policy_upper[j]);
        float largest = clip(speed, 0.0f, policy_velocity_limit[j]) * POLICY_TIMESTEP;
        float next = approached(joint_position[j], within, largest);
        joint_position[j] = clip(next, policy_lower[j], policy_upper[j]);
        there = there && fabsf(within - next) < 1e-4f;
    }
    return there;
}
