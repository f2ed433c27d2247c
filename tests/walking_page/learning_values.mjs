// Values of the page's learning for tests/walking_page/test_page_learning.py: JSON in, JSON out.

import fs from 'node:fs';
import { adder } from '../../tools/page/src/learn/adder.mjs';
import { Adam } from '../../tools/page/src/learn/network.mjs';
import { ActorCritic, advantages } from '../../tools/page/src/learn/ppo.mjs';
import { Residual } from '../../tools/page/src/learn/residual.mjs';
import { Episode } from '../../tools/page/src/learn/task.mjs';

const VALUES = {
  advantages: ({ rewards, values, ends, last, gamma, lambda }) => advantages(rewards, values, ends, last, gamma, lambda),

  gradient: ({ sizes: [observations, hidden, actions], parameters, logStd, rollout, samples }) => {
    const agent = new ActorCritic(observations, actions, hidden), gradient = new Float64Array(agent.length + 2);
    agent.parameters.set(parameters);
    agent.logStd = logStd;
    agent.addGradient(gradient, rollout, samples);
    return gradient;
  },

  adam: ({ parameters, gradients, rate }) => {
    const values = Float64Array.from(parameters), adam = new Adam(values);
    for (const gradient of gradients) adam.step(gradient, rate);
    return values;
  },

  /** Sums of two arrays by three workers, which send at different times. */
  sums: async ({ first, second }) => {
    const ports = first.map(() => Array(first.length).fill(null));
    for (let a = 0; a < first.length; a++) {
      for (let b = 0; b < a; b++) {
        const { port1, port2 } = new MessageChannel();
        [ports[a][b], ports[b][a]] = [port1, port2];
      }
    }
    const found = await Promise.all(ports.map(async (own, i) => {
      const sum = adder(own);
      if (i === 1) await new Promise((resolve) => { setTimeout(resolve, 50); });
      return [await sum(Float32Array.from(first[i])), await sum(Float32Array.from(second[i]))];
    }));
    for (const port of ports.flat()) port?.close();
    return found.map((sums) => sums.map((values) => [...values]));
  },

  /** Reward terms of the readings of each step, as if a simulation had given them. */
  terms: ({ learning, control, steps }) => {
    const simulation = {
      at: 0, robot: { start: [0, 0, 0, 1, 0, 0, 0, ...learning.stance], height: 1 }, play: learning.stance, data: { qvel: [] },
      mujoco: { mj_forward() {} }, reset() {}, step() {}, push() {},
      reading(name) { return steps[this.at][name]; },
      projectedGravity() { return this.reading('projected_gravity'); },
      fallen() { return this.reading('fallen'); },
    };
    const policy = new Residual(learning), random = { uniform: () => 0.5, either: () => 0 };
    const episode = new Episode(simulation, policy, control, random, { command: steps[0].command, turns: null, weights: learning.weights });
    const { walker } = episode;
    policy.act = () => steps[simulation.at].action;
    return steps.map(({ command, phase }, at) => {
      simulation.at = at;
      walker.command = [...command];
      walker.requested = [...command];
      walker.memory.gait_phase[0] = phase - learning.phase_step;
      const reward = episode.step(), observation = [...policy.observe(walker.inputs())];
      return { observation, reward, terms: episode.values, target: [...policy.out.joint_target] };
    });
  },
};

const { name, input } = JSON.parse(fs.readFileSync(0, 'utf8'));
process.stdout.write(JSON.stringify(await VALUES[name](input), (_, value) => (ArrayBuffer.isView(value) ? [...value] : value)));
