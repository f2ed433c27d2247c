// Proximal policy optimization (Schulman et al., arXiv 1707.06347) with a Gaussian policy, in lockstep over workers.

import { Adam, Perceptron } from './network.mjs';

export const GAMMA = 0.98;
const LAMBDA = 0.95, CLIP = 0.2, EPOCHS = 4, BATCHES = 4;
const TARGET_KL = 0.01;  // per update: the step size follows it
const RATES = [1e-4, 3e-3];  // bounds of the step size
const LOG_STD = [-3, -1];  // lower bound and start of the noise's logarithm
const STATISTICS = 3;  // behind a gradient: sums of KL, of ratios that are clipped, and number of samples

/** Advantages and returns (T * N,) of rewards, values and ends (T * N,), and the last values (N,). */
export function advantages(rewards, values, ends, lastValues, gamma = GAMMA, lambda = LAMBDA) {
  const n = lastValues.length, found = new Float32Array(rewards.length);
  for (let env = 0; env < n; env++) {
    let next = lastValues[env], sum = 0;
    for (let i = rewards.length - n + env; i >= 0; i -= n) {
      const goesOn = 1 - ends[i];
      sum = rewards[i] + gamma * goesOn * next - values[i] + gamma * lambda * goesOn * sum;
      found[i] = sum;
      next = values[i];
    }
  }
  return { advantages: found, returns: found.map((advantage, i) => advantage + values[i]) };
}

/** Policy and value function in one array of parameters: the actor's, the noise's logarithms, the critic's. */
export class ActorCritic {
  constructor(observations, actions, hidden = [64, 64]) {
    Object.assign(this, { observations, actions });
    this.actor = new Perceptron([observations, ...hidden, actions]);
    this.critic = new Perceptron([observations, ...hidden, 1]);
    this.length = this.actor.length + actions + this.critic.length;
    this.parameters = new Float32Array(this.length);
    const noise = this.actor.length, critic = noise + actions;
    this.actorParameters = this.parameters.subarray(0, noise);
    this.logStd = this.parameters.subarray(noise, critic);
    this.criticParameters = this.parameters.subarray(critic);
  }

  /** One for a `Residual`. */
  static of(policy) { return new ActorCritic(policy.observation.length, policy.out.action.length); }

  initialize(random) {
    this.actor.initialize(this.actorParameters, random, 0.01);
    this.logStd.fill(LOG_STD[1]);
    this.critic.initialize(this.criticParameters, random, 1);
  }

  mean(observations, offset) { return this.actor.forward(this.actorParameters, observations, offset); }

  value(observations, offset) { return this.critic.forward(this.criticParameters, observations, offset)[0]; }

  /** Mean of the noise's standard deviations. */
  noise() { return this.logStd.reduce((sum, value) => sum + Math.exp(value) / this.actions, 0); }

  /** Log-density of an action, which begins at `offset`, around a mean; without its constant. */
  logDensity(mean, actions, offset) {
    let sum = 0;
    for (let j = 0; j < this.actions; j++) {
      const z = (actions[offset + j] - mean[j]) * Math.exp(-this.logStd[j]);
      sum -= 0.5 * z * z + this.logStd[j];
    }
    return sum;
  }

  /**
   * Add the loss's gradient at some samples to `gradient` (length + STATISTICS,), with sums for the statistics.
   *
   * The loss of a sample: -min(r A, clip(r) A) + (V - R)^2 / 2, with the ratio of densities r.
   */
  addGradient(gradient, rollout, samples) {
    const { actor, critic, actions, logStd, length } = this, noise = actor.length;
    const g = gradient.subarray(0, noise), gNoise = gradient.subarray(noise, noise + actions);
    const gCritic = gradient.subarray(noise + actions, length);
    const slope = new Float64Array(actions), valueSlope = new Float64Array(1);
    let loss = 0;
    for (const i of samples) {
      const observation = i * actor.sizes[0], action = i * actions, advantage = rollout.advantages[i];
      const mean = this.mean(rollout.observations, observation);
      const change = this.logDensity(mean, rollout.actions, action) - rollout.logDensities[i], ratio = Math.exp(change);
      const clipped = advantage > 0 ? ratio > 1 + CLIP : ratio < 1 - CLIP;
      loss -= clipped ? advantage * (advantage > 0 ? 1 + CLIP : 1 - CLIP) : ratio * advantage;
      if (!clipped) {
        for (let j = 0; j < actions; j++) {
          const precision = Math.exp(-2 * logStd[j]), away = rollout.actions[action + j] - mean[j];
          slope[j] = -ratio * advantage * away * precision;
          gNoise[j] -= ratio * advantage * (away * away * precision - 1);
        }
        actor.backward(this.actorParameters, g, slope);
      }
      valueSlope[0] = this.value(rollout.observations, observation) - rollout.returns[i];
      loss += 0.5 * valueSlope[0] ** 2;
      critic.backward(this.criticParameters, gCritic, valueSlope);
      gradient[length] += ratio - 1 - change;  // an estimate of KL without bias that is never negative
      gradient[length + 1] += clipped;
    }
    gradient[length + 2] += samples.length;
    return loss;
  }
}

/** Optimizer of one worker's copy of the parameters: all make the same steps, since their gradients are added. */
export class Optimizer {
  /**
   * @param model the `ActorCritic`
   * @param random a `Random`, which shuffles this worker's samples
   * @param sum function that adds an array over the workers
   */
  constructor(model, random, sum) {
    Object.assign(this, { model, random, sum, rate: 1e-3, adam: new Adam(model.length) });
  }

  /** One update from a rollout whose advantages are normalized over all workers. */
  async update(rollout) {
    const { model } = this, order = rollout.returns.map((_, i) => i), size = order.length / BATCHES;
    for (let epoch = 0; epoch < EPOCHS; epoch++) {
      for (let i = order.length - 1; i > 0; i--) {
        const j = Math.floor(this.random.uniform() * (i + 1));
        [order[i], order[j]] = [order[j], order[i]];
      }
      for (let batch = 0; batch < BATCHES; batch++) {
        const own = new Float32Array(model.length + STATISTICS);
        model.addGradient(own, rollout, order.subarray(Math.round(batch * size), Math.round((batch + 1) * size)));
        const all = await this.sum(own), count = all[model.length + 2], kl = all[model.length] / count;
        for (let i = 0; i < model.length; i++) all[i] /= count;
        if (kl > 2 * TARGET_KL) this.rate = Math.max(RATES[0], this.rate / 1.5);
        else if (kl < TARGET_KL / 2) this.rate = Math.min(RATES[1], this.rate * 1.5);
        this.adam.step(model.parameters, all, this.rate);
        for (let j = 0; j < model.actions; j++) model.logStd[j] = Math.max(LOG_STD[0], model.logStd[j]);
      }
    }
  }
}
