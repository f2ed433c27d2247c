// One worker's part of learning: rollouts with its own robots, then updates in lockstep with the other workers.

import { Simulation } from '../simulation.mjs';
import { adder } from './adder.mjs';
import { Random } from './network.mjs';
import { ActorCritic, GAMMA, Optimizer, advantages } from './ppo.mjs';
import { Residual } from './residual.mjs';
import { Episode } from './task.mjs';

const NUM_ENVS = 64;  // of all workers together
const STEPS = 32;  // control steps of an env per rollout

/** What the robots of one worker did in some control steps: arrays (T * N, ...), by steps. */
class Rollout {
  constructor(agent, envs) {
    const size = STEPS * envs.length;
    Object.assign(this, { agent, envs, at: 0, noisy: false });
    this.observations = new Float32Array(size * agent.observations);
    this.actions = new Float32Array(size * agent.actions);
    for (const env of envs) env.policy.act = (observation) => this.act(observation, env.random);
    for (const name of ['logDensities', 'values', 'rewards', 'ends']) this[name] = new Float32Array(size);
  }

  /** Draw an action for an observation, and note both. */
  act(observation, random) {
    const { agent, at } = this, mean = agent.mean(observation), first = at * agent.actions, std = Math.exp(agent.logStd);
    this.observations.set(observation, at * agent.observations);
    for (let j = 0; j < agent.actions; j++) {
      this.actions[first + j] = this.noisy ? mean[j] + std * random.normal() : 0;
    }
    this.logDensities[at] = agent.logDensity(mean, this.actions, first);
    this.values[at] = agent.value(observation);
    return this.actions.subarray(first, first + agent.actions);
  }

  /** Run all envs; sets advantages and returns, and gives sums: reward, speed and falls. */
  collect() {
    const { agent, envs } = this, totals = [0, 0, 0], value = (env) => agent.value(env.policy.observe(env.walker.inputs()));
    this.at = 0;
    for (let t = 0; t < STEPS; t++) {
      for (const env of envs) {
        const reward = env.step();
        [reward, env.velocity, env.fell].forEach((one, i) => { totals[i] += Number(one); });
        // An episode whose time is up would have gone on.
        this.rewards[this.at] = reward + (env.ended && !env.fell ? GAMMA * value(env) : 0);
        this.ends[this.at++] = Number(env.ended);
        if (env.ended) env.reset();
      }
    }
    Object.assign(this, advantages(this.rewards, this.values, this.ends, envs.map(value)));
    return totals;
  }
}

/**
 * Learn, one iteration per turn. In the first one all actions are zero: what the gait alone earns.
 * @param mujoco result of `loadMujoco`
 * @param page content of the page; see quadruped_env/walking_page/document.py
 * @param settings `{seed, command, turns, weights}`: seed of all random numbers, and see `Episode`
 * @param ports as of `adder`
 * @yields results of an iteration over all workers
 */
export async function* learn(mujoco, page, settings, ports) {
  const { learning, control } = page, index = ports.indexOf(null), sum = adder(ports);
  const random = (number) => new Random(1000 * settings.seed + number);
  const envs = [], scene = { xml: page.terrains[0].xml };
  for (let number = index; number < NUM_ENVS; number += ports.length) {
    const simulation = new Simulation(mujoco, scene, page.robot);
    envs.push(new Episode(simulation, new Residual(learning), control, random(number), settings));
  }
  const agent = ActorCritic.of(envs[0].policy);
  agent.initialize(random(999));
  const optimizer = new Optimizer(agent, random(900 + index), sum);
  const samples = new Rollout(agent, envs);
  for (let iteration = 0; ; iteration++) {
    samples.noisy = iteration > 0;
    agent.setNoise(iteration * STEPS * NUM_ENVS);
    const totals = samples.collect(), { advantages: found } = samples;
    const squares = found.reduce((total, value) => total + value * value, 0);
    const [count, all, allSquares, reward, speed, falls] = await sum(
      Float32Array.of(found.length, found.reduce((total, value) => total + value, 0), squares, ...totals));
    const mean = all / count, std = Math.sqrt(allSquares / count - mean * mean) + 1e-8;
    samples.advantages = found.map((value) => (value - mean) / std);
    if (samples.noisy) await optimizer.update(samples);
    const seconds = count * control.timestep;
    yield {
      steps: iteration * count, reward: reward / seconds, speed: speed / count, falls: falls / seconds,
      noise: Math.exp(agent.logStd), rate: optimizer.rate, actor: agent.actorParameters.slice(),
    };
  }
}
