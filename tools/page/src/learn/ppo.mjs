// Proximal policy optimization (Schulman et al., arXiv 1707.06347) with a Gaussian policy, in lockstep over workers.

import { Adam, Perceptron } from './network.mjs';

export const GAMMA = 0.98;
const LAMBDA = 0.95, CLIP = 0.2, EPOCHS = 4, BATCHES = 4;
/** The actor's step size follows the Kullback-Leibler divergence of an update, within bounds. */
const TARGET_KL = 0.02, RATES = [1e-4, 3e-3], CRITIC_RATE = 1e-3;
/** Logarithm of the noise's standard deviation: at the start, at the end, and the number of steps between. */
const NOISE = [-1, -2.5, 300_000];

/** Advantages and returns (T * N,) from rewards, values and ends (T * N,), and the values after the last step (N,). */
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

/** Policy and value function, whose parameters are one array: the actor's, then the critic's. */
export class ActorCritic {
  constructor(observations, actions, hidden = [64, 64]) {
    Object.assign(this, { observations, actions, logStd: NOISE[0] });
    this.actor = new Perceptron([observations, ...hidden, actions]);
    this.critic = new Perceptron([observations, ...hidden, 1]);
    this.length = this.actor.length + this.critic.length;
    this.parameters = new Float32Array(this.length);
    this.actorParameters = this.parameters.subarray(0, this.actor.length);
    this.criticParameters = this.parameters.subarray(this.actor.length);
  }

  /** One for a `Residual`. */
  static of(policy) { return new ActorCritic(policy.observation.length, policy.out.action.length); }

  initialize(random) {
    // Of a small last layer: the first actions are nearly zero.
    this.actor.initialize(this.actorParameters, random, 0.01);
    this.critic.initialize(this.criticParameters, random, 1);
  }

  /** Reduce the noise as the steps go on. */
  setNoise(steps) {
    const [first, last, length] = NOISE;
    this.logStd = first + (last - first) * Math.min(1, steps / length);
  }

  mean(observations, offset) { return this.actor.forward(this.actorParameters, observations, offset); }

  value(observations, offset) { return this.critic.forward(this.criticParameters, observations, offset)[0]; }

  /** Logarithm of the density of an action, which begins at `offset`, around a mean; without its constant. */
  logDensity(mean, actions, offset) {
    const precision = Math.exp(-2 * this.logStd);
    let sum = 0;
    for (let j = 0; j < this.actions; j++) sum -= 0.5 * precision * (actions[offset + j] - mean[j]) ** 2;
    return sum - this.actions * this.logStd;
  }

  /**
   * Add the gradient of the loss over some samples to `gradient` (length + 2,); at its end, the divergence and the number of samples.
   *
   * The loss of a sample with the ratio r of the densities is -min(r A, clip(r) A) + (V - R)^2 / 2.
   */
  addGradient(gradient, rollout, samples) {
    const { actor, critic, actions, observations, length } = this, precision = Math.exp(-2 * this.logStd);
    const ofActor = gradient.subarray(0, actor.length), ofCritic = gradient.subarray(actor.length, length);
    const slope = new Float64Array(actions), error = new Float64Array(1);
    for (const i of samples) {
      const advantage = rollout.advantages[i], mean = this.mean(rollout.observations, i * observations);
      const change = this.logDensity(mean, rollout.actions, i * actions) - rollout.logDensities[i], ratio = Math.exp(change);
      // Beyond the clip the loss is constant.
      if (advantage > 0 ? ratio < 1 + CLIP : ratio > 1 - CLIP) {
        for (let j = 0; j < actions; j++) slope[j] = -ratio * advantage * precision * (rollout.actions[i * actions + j] - mean[j]);
        actor.backward(this.actorParameters, ofActor, slope);
      }
      error[0] = this.value(rollout.observations, i * observations) - rollout.returns[i];
      critic.backward(this.criticParameters, ofCritic, error);
      gradient[length] += ratio - 1 - change;  // an estimate that is never negative
    }
    gradient[length + 1] += samples.length;
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
    Object.assign(this, { model, random, sum, rate: CRITIC_RATE });
    this.actor = new Adam(model.actorParameters);
    this.critic = new Adam(model.criticParameters);
  }

  /** One update from a rollout whose advantages are normalized over all workers. */
  async update(rollout) {
    const { model, actor, critic } = this, order = Uint32Array.from(rollout.returns, (_, i) => i), size = order.length / BATCHES;
    for (let epoch = 0; epoch < EPOCHS; epoch++) {
      this.random.shuffle(order);
      for (let batch = 0; batch < BATCHES; batch++) {
        const own = new Float32Array(model.length + 2);
        model.addGradient(own, rollout, order.subarray(Math.round(batch * size), Math.round((batch + 1) * size)));
        const all = await this.sum(own), count = all[model.length + 1], divergence = all[model.length] / count;
        const gradient = all.map((value) => value / count);
        if (divergence > 2 * TARGET_KL) this.rate = Math.max(RATES[0], this.rate / 1.5);
        else if (divergence < TARGET_KL / 2) this.rate = Math.min(RATES[1], this.rate * 1.5);
        actor.step(gradient, this.rate);
        critic.step(gradient.subarray(model.actor.length), CRITIC_RATE);
      }
    }
  }
}
