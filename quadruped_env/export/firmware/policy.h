/* A policy for a robot: readings in SI units to joint targets in rad, once every POLICY_TIMESTEP.

   C99 and math.h, no allocation, no state but what the caller keeps in a policy_memory. Do not compile it with
   -ffast-math, -ffinite-math-only or /fp:fast: NaN means "not observed yet" in the history, and marks readings that
   cannot be used. */

#ifndef POLICY_H
#define POLICY_H

#if defined __FAST_MATH__ || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__ > 0) || defined _M_FP_FAST
#error "policy.c needs NaN: compile it without -ffast-math, -Ofast, -ffinite-math-only and /fp:fast"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* constants */

/* Readings of one step, in the base frame: x forward, y left, z up. */
typedef struct {
    /* readings */
} policy_readings;

/* What the policy keeps from one step to the next. */
typedef struct {
    float command[POLICY_COMMANDS]; /* on its way to the requested one */
    float last_action[POLICY_JOINTS]; /* in [-1, 1] */
    float gait_phase; /* rad */
#if POLICY_HISTORY > 0
    float observation_history[POLICY_HISTORY]; /* scaled, the latest first; NaN: none yet */
#endif
} policy_memory;

/* Joints in the order of all arrays; rad and rad/s. */
extern const char *const policy_joint_names[POLICY_JOINTS];
extern const float policy_stance[POLICY_JOINTS];
extern const float policy_lower[POLICY_JOINTS];
extern const float policy_upper[POLICY_JOINTS];
extern const float policy_velocity_limit[POLICY_JOINTS];
extern const float policy_command_low[POLICY_COMMANDS];
extern const float policy_command_high[POLICY_COMMANDS];
extern const float policy_command_rate[POLICY_COMMANDS];

/* Begin: the robot stands in the stance. */
void policy_reset(policy_memory *memory);

/* One control step. The requested velocities (m/s, rad/s) are clipped to the policy's range, and followed at its rate.
   Returns 1, or 0 if a reading, a requested velocity or a joint target is NaN: then memory and joint_target stay as
   they are. After POLICY_INVALID_AFTER of this, switch the motors off. */
int policy_step(const policy_readings *readings, const float requested[POLICY_COMMANDS], policy_memory *memory,
                float joint_target[POLICY_JOINTS]);

/* The graph of policy.onnx: memory->command is an input, the rest of the memory is replaced by the outputs. */
void policy_graph(const policy_readings *readings, policy_memory *memory, float joint_target[POLICY_JOINTS]);

/* Move joint positions towards a target, within the joints' ranges and at most at a speed (rad/s) in one control step.
   Returns 1 if they are there. */
int policy_approach(const float target[POLICY_JOINTS], float speed, float joint_position[POLICY_JOINTS]);

#ifdef __cplusplus
}
#endif

#endif
