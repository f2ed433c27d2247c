// One worker's part of learning: rollouts with its own robots, then updates in lockstep with the other workers.

import { Simulation } from '../simulation.mjs';
import { adder } from './adder.mjs';
import { Random } from './network.mjs';
import { ActorCritic, Optimizer } from './ppo.mjs';
import { Residual } from './residual.mjs';
import { Rollout } from './rollout.mjs';
import { Episode } from './task.mjs';

const NUM_ENVS = 64;  // of all workers together

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
    agent.setNoise(iteration * samples.steps * NUM_ENVS);
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
