// Rollouts of one worker's robots.

import { GAMMA, advantages } from './ppo.mjs';

/** What the robots of one worker did in some control steps: arrays (T * N, ...), by steps. */
export class Rollout {
  /**
   * @param agent an `ActorCritic`
   * @param envs `Episode`s, whose policies then act as the agent does
   * @param steps control steps of an env
   */
  constructor(agent, envs, steps = 32) {
    const size = steps * envs.length;
    Object.assign(this, { agent, envs, steps, at: 0, noisy: false });
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
    for (let t = 0; t < this.steps; t++) {
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
