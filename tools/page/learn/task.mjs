// The task: walk at a commanded speed, as a residual on a gait that marches on the spot. Formulas and weights of the
// terms are those of the package's task.

export const WEIGHTS = { tracking: 9, progress: 9, foot_lift: 8, upright: -10, base_motion: -2, action_rate: -1, fall: -250 };
const SPEED_STD = 0.07, YAW_RATE_STD = 0.15, SMOOTHING = 0.4, BASE_ARM = 0.2;  // m/s, rad/s, s, m
const EPISODE = 400;  // control steps

/** Robots of one worker, side by side, each with a state of its own. */
export class Task {
  /**
   * @param mj MuJoCo's module
   * @param model its model
   * @param robot numbers of the robot and its gait
   * @param randoms one generator per env
   * @param settings command ranges and weights, which may change at any time
   */
  constructor(mj, model, robot, randoms, settings) {
    Object.assign(this, { mj, model, robot, settings, joints: robot.stance.length, legs: robot.feet.length });
    this.width = 6 + 3 * this.joints + 4;
    const datas = randoms.map(() => new mj.MjData(model));
    this.envs = datas.map((data, i) => ({
      data, random: randoms[i], qpos: data.qpos, qvel: data.qvel, ctrl: data.ctrl, sites: data.site_xpos,
      action: new Float64Array(this.joints), previous: new Float64Array(this.joints), command: [0, 0], smooth: [0, 0],
    }));
    for (const env of this.envs) { this.reset(env); env.steps = Math.floor(EPISODE * env.random.uniform()); }
  }

  reset(env) {
    const { random, qpos, qvel } = env, { stance, height } = this.robot;
    this.mj.mj_resetData(this.model, env.data);
    qpos.set([0, 0, height + 0.005]);
    const roll = random.between(-0.05, 0.05) / 2, pitch = random.between(-0.05, 0.05) / 2;
    qpos.set([Math.sqrt(1 - roll * roll - pitch * pitch), roll, pitch, 0], 3);
    for (let j = 0; j < this.joints; j++) {
      qpos[7 + j] = stance[j] + random.between(-0.1, 0.1);
      qvel[6 + j] = random.between(-0.5, 0.5);
    }
    for (let i = 0; i < 6; i++) qvel[i] = random.between(-0.2, 0.2);
    const { speeds, yawRates } = this.settings;
    env.command = [random.between(...speeds), random.between(...yawRates)];
    env.phase = 2 * Math.PI * random.uniform();
    env.action.fill(0);
    env.previous.fill(0);
    env.smooth = [0, 0];
    env.steps = 0;
    env.ended = env.fell = false;
    this.read(env);
  }

  /** Up axis and velocity of the base in its own frame. */
  read(env) {
    const { qpos, qvel } = env, w = qpos[3], x = qpos[4], y = qpos[5], z = qpos[6];
    const along = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
    const left = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
    const up = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
    const dot = (axis) => axis[0] * qvel[0] + axis[1] * qvel[1] + axis[2] * qvel[2];
    env.up = [along[2], left[2], up[2]];
    env.velocity = [dot(along), dot(left), dot(up)];
  }

  /** Write an env's observation to `out` from `offset` on. */
  observe(env, out, offset) {
    const { qpos, qvel, phase, command } = env, { stance, velocityLimit } = this.robot;
    const put = (value, bound = 1) => { out[offset++] = Math.max(-bound, Math.min(bound, value)); };
    for (let i = 0; i < 3; i++) put(-env.up[i]);
    for (let i = 3; i < 6; i++) put(0.25 * qvel[i], 4);
    for (let j = 0; j < this.joints; j++) put(qpos[7 + j] - stance[j], 3);
    for (let j = 0; j < this.joints; j++) put(qvel[6 + j] / velocityLimit, 3);
    for (let j = 0; j < this.joints; j++) put(env.action[j]);
    put(4 * command[0], 4);
    put(4 * command[1], 4);
    put(Math.sin(phase));
    put(Math.cos(phase));
  }

  /** One control step with an action, which begins at `offset`; returns the reward. */
  step(env, actions, offset) {
    const { robot, mj, model } = this, { ctrl, command, smooth, qvel } = env, dt = robot.timestep;
    env.phase = (env.phase + 2 * Math.PI * robot.frequency * dt) % (2 * Math.PI);
    let rate = 0;
    for (let j = 0; j < this.joints; j++) {
      const angle = env.phase + robot.phases[j], action = Math.max(-1, Math.min(1, actions[offset + j]));
      rate += (action - env.action[j]) ** 2;
      env.action[j] = action;
      const target = robot.sine[j] * Math.sin(angle) + robot.cosine[j] * Math.cos(angle) + robot.offset[j];
      ctrl[j] = Math.max(robot.low[j], Math.min(robot.high[j], target + robot.scale * action));
    }
    for (let s = 0; s < robot.decimation; s++) mj.mj_step(model, env.data);
    this.read(env);
    env.steps++;
    const { up, velocity } = env;
    smooth[0] += dt / SMOOTHING * (velocity[0] - smooth[0]);
    smooth[1] += dt / SMOOTHING * (qvel[5] - smooth[1]);
    let lift = 0;
    for (let leg = 0; leg < this.legs; leg++) {
      const missing = Math.min(1, Math.abs(1 - (env.sites[3 * robot.feet[leg] + 2] - robot.footRadius) / robot.footLift));
      lift += Math.sin(env.phase + robot.phases[2 * leg]) * (1 - 2 * missing * missing) / this.legs;
    }
    env.fell = up[2] < 0.54 || env.qpos[2] < 0.5 * robot.height;
    env.ended = env.fell || env.steps >= EPISODE;
    const peak = (error, std) => Math.exp(-((error / std) ** 2));
    const progress = (is, command, smallest) => {
      const size = Math.max(Math.abs(command), smallest), share = is * Math.sign(command) / size;
      return Math.max(-1, share - 2 * Math.max(0, share - Math.abs(command) / size));
    };
    const terms = {
      tracking: peak(smooth[0] - command[0], SPEED_STD) + peak(smooth[1] - command[1], YAW_RATE_STD),
      progress: progress(smooth[0], command[0], 0.1) + progress(smooth[1], command[1], 0.2),
      foot_lift: lift,
      upright: up[0] ** 2 + up[1] ** 2,
      base_motion: velocity[1] ** 2 + velocity[2] ** 2 + BASE_ARM ** 2 * (qvel[3] ** 2 + qvel[4] ** 2),
      action_rate: rate,
      fall: +env.fell,
    };
    let reward = 0;
    for (const name in terms) reward += this.settings.weights[name] * terms[name];
    return dt * reward;
  }
}
