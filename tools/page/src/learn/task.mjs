// The task that is learned: follow a velocity command, with reward terms of quadruped_env/task/rewards.py.

import { Walker } from '../walker.mjs';

const EPISODE = 8;  // s
const START = { joints: 0.1, tilt: 0.05, velocity: 0.2 };  // largest random change of the start: rad, rad, m/s
const PUSH = 0.3;  // largest velocity of a push, m/s
const CHANGES = 3;  // mean time between two pushes, each with a new command, s

/** One robot that learns, with its reward. */
export class Episode {
  /**
   * @param simulation a `Simulation`
   * @param policy a `Residual`
   * @param control as of a `Walker`
   * @param random a `Random`
   * @param settings `{command, turns, weights}`, which may change at any time: the velocity command; whether slower
   *   ones and turns up to a yaw rate (rad/s) are learned, too, or null; the reward's weights per second
   */
  constructor(simulation, policy, control, random, settings) {
    Object.assign(this, { simulation, policy, control, random, settings, learning: policy.learning });
    this.walker = new Walker(simulation, policy, control);
    this.previous = new Float32Array(policy.out.action.length);
    this.reset();
    this.walker.time = EPISODE * random.uniform();  // so that not all episodes end at once
  }

  reset() {
    const { random, simulation, walker, learning } = this;
    const start = [...simulation.robot.start];
    start[2] += 0.03 * simulation.robot.height;  // above the ground, whatever the joints do
    start.splice(3, 4, 1, random.either(START.tilt / 2), random.either(START.tilt / 2), 0);
    walker.reset(start.map((value, i) => (i < 7 ? value : value + random.either(START.joints))), this.drawCommand());
    walker.memory.gait_phase[0] = 2 * Math.PI * random.uniform();
    for (let i = 0; i < 3; i++) simulation.data.qvel[i] = random.either(START.velocity * learning.unit[0]);
    simulation.mujoco.mj_forward(simulation.model, simulation.data);
    this.previous.fill(0);
    this.smooth = [0, 0];
  }

  /** The command to learn; or one that goes slower and turns, which every second one does. */
  drawCommand() {
    const { random, settings: { command: [forward, turn], turns } } = this;
    return turns === null || random.uniform() < 0.5 ? [forward, turn] : [forward * random.uniform(), random.either(turns)];
  }

  /** One control step; returns the reward, and sets `fell` and `ended`. */
  step() {
    const { walker, simulation, random, control, learning } = this, dt = control.timestep;
    if (random.uniform() < dt / CHANGES) {
      const size = PUSH * learning.unit[0] * random.uniform(), direction = 2 * Math.PI * random.uniform();
      simulation.push([size * Math.cos(direction), size * Math.sin(direction), 0]);
      walker.requested = this.drawCommand();
    }
    const command = [...walker.command];  // in force during the step
    walker.step();
    this.fell = simulation.fallen();
    this.ended = this.fell || walker.time >= EPISODE;
    let reward = 0;
    this.values = this.terms(command);
    for (const [name, value] of Object.entries(this.values)) reward += this.settings.weights[name] * value;
    if (!Number.isFinite(reward)) reward = this.settings.weights.fall;  // the simulation has diverged
    this.previous.set(this.policy.out.action);
    return dt * reward;
  }

  /** Values of the reward terms by name, for a command. */
  terms(command) {
    const { simulation, learning, smooth, walker, policy } = this;
    const gravity = simulation.projectedGravity(), v = simulation.reading('linear_velocity_b');
    const w = simulation.reading('angular_velocity_b');
    this.velocity = v[0];
    [v[0], w[2]].forEach((value, i) => { smooth[i] += learning.smoothing * (value - smooth[i]); });
    const peak = (i) => Math.exp(-(((smooth[i] - command[i]) / learning.std[i]) ** 2));
    const progress = (i) => {
      const size = Math.max(Math.abs(command[i]), [0.1, 0.2][i] * learning.unit[i]);
      const share = (smooth[i] * Math.sign(command[i])) / size, whole = Math.abs(command[i]) / size;
      return Math.max(-1, share - 2 * Math.max(0, share - whole));
    };
    const position = simulation.reading('foot_position'), force = simulation.reading('foot_force');
    let lifted = 0, carried = 0;
    for (let leg = 0; leg < force.length; leg++) {
      const swing = Math.sin(walker.memory.gait_phase[0] + learning.leg_phases[leg]) / force.length;
      const missing = 1 - (position[3 * leg + 2] - learning.foot_radius) / learning.foot_lift;
      lifted += swing * Math.max(-1, 1 - 2 * missing * missing);
      carried += swing * (force[leg] > learning.contact_threshold ? -1 : 1);
    }
    let rate = 0;
    policy.out.action.forEach((value, j) => { rate += (value - this.previous[j]) ** 2; });
    return {
      track_forward_velocity: peak(0), track_yaw_rate: peak(1), forward_progress: progress(0), turn_progress: progress(1),
      gait_clock: lifted, contact_clock: carried, upright: gravity[0] ** 2 + gravity[1] ** 2,
      base_motion: v[1] ** 2 + v[2] ** 2 + learning.base_arm ** 2 * (w[0] ** 2 + w[1] ** 2),
      action_rate: rate, fall: Number(this.fell),
    };
  }
}
