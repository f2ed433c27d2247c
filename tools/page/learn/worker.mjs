// What every worker does: rollouts with its own robots, then updates in lockstep with the other workers.

import { Random } from './network.mjs';
import { ActorCritic, Learner, advantages } from './ppo.mjs';
import { Task } from './task.mjs';

const STEPS = 32;  // control steps of an env per rollout
export const NUM_ENVS = 64;  // of all workers together

/** Sum of an array over the workers, added in their order, so that every one of them has the same bits. */
function adder(ports, index) {
  const queues = ports.map(() => []), waiting = ports.map(() => null);
  ports.forEach((port, i) => {
    if (port) port.onmessage = ({ data }) => { waiting[i] ? waiting[i](data) : queues[i].push(data); waiting[i] = null; };
  });
  const next = (i) => queues[i].length ? queues[i].shift() : new Promise((resolve) => { waiting[i] = resolve; });
  return async (values) => {
    for (const port of ports) port?.postMessage(values);
    const all = await Promise.all(ports.map((port, i) => port ? next(i) : values));
    const total = new Float32Array(values.length);
    for (const one of all) for (let i = 0; i < total.length; i++) total[i] += one[i];
    return total;
  };
}

/**
 * Learn until the worker is terminated.
 *
 * @param mj MuJoCo's module
 * @param model its model
 * @param robot numbers of the robot
 * @param settings what is learned, and whether to pause: { speeds, yawRates, weights, seed, paused }
 * @param ports one message port per worker, null for this one
 * @param report called after every iteration
 */
export async function learn(mj, model, robot, settings, ports, index, report, turn) {
  const workers = ports.length, sum = adder(ports, index), dt = robot.timestep;
  const randoms = [];
  for (let env = index; env < NUM_ENVS; env += workers) randoms.push(new Random(1000 * settings.seed + env));
  const task = new Task(mj, model, robot, randoms, settings), { envs, width, joints } = task, n = envs.length;
  const agent = new ActorCritic(width, joints);
  agent.initialize(new Random(1000 * settings.seed + 999));
  const learner = new Learner(agent, new Random(1000 * settings.seed + 500 + index), sum);
  const size = STEPS * n, rollout = {
    observations: new Float32Array(size * width), actions: new Float32Array(size * joints),
    logDensities: new Float32Array(size), rewards: new Float32Array(size), values: new Float32Array(size), ends: new Uint8Array(size),
  };
  const last = new Float32Array(width), lastValues = new Float32Array(n);
  for (let iteration = 0; ; iteration++) {
    await turn();
    const zero = iteration === 0;  // the first rollout shows what a zero action earns
    let reward = 0, speed = 0, falls = 0;
    for (let t = 0, i = 0; t < STEPS; t++) {
      for (const env of envs) {
        task.observe(env, rollout.observations, i * width);
        const mean = agent.mean(rollout.observations, i * width);
        for (let j = 0; j < joints; j++) {
          rollout.actions[i * joints + j] = zero ? 0 : mean[j] + Math.exp(agent.logStd[j]) * env.random.normal();
        }
        rollout.logDensities[i] = agent.logDensity(mean, rollout.actions, i * joints);
        rollout.values[i] = agent.value(rollout.observations, i * width);
        rollout.rewards[i] = task.step(env, rollout.actions, i * joints);
        rollout.ends[i] = env.ended;
        reward += rollout.rewards[i]; speed += env.velocity[0]; falls += env.fell;
        if (env.ended) {
          if (!env.fell) {  // time is up: what would have come counts
            task.observe(env, last, 0);
            rollout.rewards[i] += 0.98 * agent.value(last, 0);
          }
          task.reset(env);
        }
        i++;
      }
    }
    envs.forEach((env, e) => { task.observe(env, last, 0); lastValues[e] = agent.value(last, 0); });
    Object.assign(rollout, advantages(rollout.rewards, rollout.values, rollout.ends, lastValues));
    let total = 0, squares = 0;
    for (const a of rollout.advantages) { total += a; squares += a * a; }
    const [a, a2, count, rewards, speeds, fallen] = await sum(Float32Array.of(total, squares, size, reward, speed, falls));
    const mean = a / count, std = Math.sqrt(a2 / count - mean * mean) + 1e-8;
    for (let i = 0; i < size; i++) rollout.advantages[i] = (rollout.advantages[i] - mean) / std;
    if (!zero) await learner.update(rollout);
    report({
      iteration, steps: iteration * STEPS * NUM_ENVS, reward: rewards / count / dt, speed: speeds / count, falls: fallen / count / dt,
      rate: learner.rate, noise: agent.logStd.reduce((s, x) => s + Math.exp(x) / joints, 0), parameters: agent.actorParameters,
    });
  }
}
