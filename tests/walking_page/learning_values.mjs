// Values of the page's learning for tests/walking_page/test_page_learning.py: JSON in, JSON out.

import fs from 'node:fs';
import { adder } from '../../tools/page/src/learn/adder.mjs';
import { Adam, Random } from '../../tools/page/src/learn/network.mjs';
import { ActorCritic, advantages } from '../../tools/page/src/learn/ppo.mjs';
import { Residual } from '../../tools/page/src/learn/residual.mjs';
import { Rollout } from '../../tools/page/src/learn/rollout.mjs';
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

  /** Rewards and ends of a rollout of envs that each end once, by a fall or by time; all rewards are 1, all values 10. */
  rollout: ({ steps, ends }) => {
    const envs = ends.map(({ step, fell }) => ({
      policy: { observe: () => Float32Array.of(10) }, walker: { inputs() {} }, velocity: 0, at: 0,
      step() {
        this.policy.act(this.policy.observe());
        this.ended = ++this.at === step;
        this.fell = this.ended && fell;
        return 1;
      },
      reset() {},
    }));
    const agent = { observations: 1, actions: 1, logStd: 0, mean: () => [0], logDensity: () => 0, value: ([value]) => value };
    const rollout = new Rollout(agent, envs, steps);
    return { totals: rollout.collect(), rewards: rollout.rewards, ends: rollout.ends };
  },

  /** Reward terms of the readings of each step, as if a simulation had given them. */
  terms: ({ learning, control, steps }) => {
    const random = { uniform: () => 0.5, either: () => 0 };
    const { episode, simulation } = made(learning, control, random, { command: steps[0].command, turns: null }, steps);
    const { walker, policy } = episode;
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

  /** Terms of two steps with the same readings, and of the first one after a reset. */
  reset: ({ learning, control, step }) => {
    const { episode } = made(learning, control, new Random(0), { command: step.command, turns: null }, [step]);
    episode.policy.act = () => step.action;
    return [false, false, true].map((begin) => {
      if (begin) episode.reset();
      episode.step();
      return episode.values;
    });
  },

  /** What a step with some readings, that begins at a time of the episode, gives. */
  end: ({ learning, control, step, time }) => {
    const { episode } = made(learning, control, new Random(0), { command: step.command, turns: null }, [step]);
    episode.policy.act = () => step.action;
    episode.walker.time = time;
    const reward = episode.step(), { fell, ended } = episode;
    return { reward, fell, ended };
  },

  /** Velocities of all pushes in some steps, and the requested velocities after each. */
  pushes: ({ learning, control, step, count, turns }) => {
    const { episode, simulation } = made(learning, control, new Random(1), { command: step.command, turns }, [step]);
    episode.policy.act = () => step.action;
    const pushes = [], requests = [];
    for (let i = 0; i < count; i++) {
      simulation.pushed = null;
      episode.step();
      if (simulation.pushed) {
        pushes.push(simulation.pushed);
        requests.push([...episode.walker.requested]);
      }
    }
    return { pushes, requests };
  },
};

/** An episode in a simulation whose readings come from a step, `simulation.at`. */
function made(learning, control, random, settings, steps) {
  const simulation = {
    at: 0, robot: { start: [0, 0, 0, 1, 0, 0, 0, ...learning.stance], height: 1 }, play: learning.stance, data: { qvel: [] },
    mujoco: { mj_forward() {} }, reset() {}, step() {}, push(velocity) { this.pushed = velocity; },
    reading(name) { return steps[this.at][name]; },
    projectedGravity() { return this.reading('projected_gravity'); },
    fallen() { return this.reading('fallen'); },
  };
  return { simulation, episode: new Episode(simulation, new Residual(learning), control, random, { weights: learning.weights, ...settings }) };
}

const { name, input } = JSON.parse(fs.readFileSync(0, 'utf8'));
process.stdout.write(JSON.stringify(await VALUES[name](input), (_, value) => (ArrayBuffer.isView(value) ? [...value] : value)));
