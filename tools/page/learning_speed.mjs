// Processor time until a robot that marches on the spot walks at the commanded speed.
// usage: node learning_speed.mjs PAGE.json [WORKERS] [SEEDS] [SECONDS]
// PAGE.json: content of a page, `page_document` of quadruped_env/walking_page/document.py.

import fs from 'node:fs';
import { createRequire } from 'node:module';
import { isMainThread, MessageChannel, parentPort, Worker, workerData } from 'node:worker_threads';
import { learn } from './src/learn/learner.mjs';
import { ActorCritic } from './src/learn/ppo.mjs';
import { Residual } from './src/learn/residual.mjs';
import { loadMujoco, Simulation } from './src/simulation.mjs';
import { Walker } from './src/walker.mjs';

/** Iterations between two walks, and number of walks in a row that have to meet the command. */
const EVERY = 5, KEPT = 3;

const wasm = fs.readFileSync(createRequire(import.meta.url).resolve('@mujoco/mujoco/mujoco.wasm'));
const seconds = () => process.cpuUsage().user / 1e6 + process.cpuUsage().system / 1e6;

/** Mean forward velocity and yaw rate of a walker in the last 4 of 6 s; null after a fall. */
function walk(walker, command) {
  const { simulation, control } = walker, velocity = [0, 0];
  walker.reset(undefined, command);
  while (walker.time < 6) {
    walker.step();
    if (simulation.fallen()) return null;
    if (walker.time < 2) continue;
    velocity[0] += (simulation.reading('linear_velocity_b')[0] * control.timestep) / 4;
    velocity[1] += (simulation.reading('angular_velocity_b')[2] * control.timestep) / 4;
  }
  return velocity;
}

async function measure(page, workers, seed, limit) {
  const { learning, control } = page, command = learning.command;
  const simulation = new Simulation(await loadMujoco(wasm), { xml: page.terrains[0].xml }, page.robot);
  const policy = new Residual(learning), agent = ActorCritic.of(policy), walker = new Walker(simulation, policy, control);
  policy.act = (observation) => agent.mean(observation);
  const ports = Array.from({ length: workers }, () => Array(workers).fill(null));
  for (let a = 0; a < workers; a++) {
    for (let b = 0; b < a; b++) { const { port1, port2 } = new MessageChannel(); ports[a][b] = port1; ports[b][a] = port2; }
  }
  const start = seconds(), clock = performance.now();
  // Time of this thread's own walks, iterations, and the first of the latest walks that met the command.
  let apart = 0, iteration = 0, met = [];
  const threads = ports.map((own) => new Worker(new URL(import.meta.url), {
    workerData: { page, ports: own, settings: { seed, command, turns: null, weights: learning.weights } }, transferList: own.filter(Boolean),
  }));
  await new Promise((resolve) => threads[0].on('message', ({ actor, ...result }) => {
    const used = seconds() - start - apart;
    if (iteration++ % EVERY) return;
    agent.actorParameters.set(actor);
    const velocity = walk(walker, command);
    apart = seconds() - start - used;
    // As "commands met" of the package's suite.
    const meets = velocity && Math.abs(velocity[0] - command[0]) < 0.05 && Math.abs(velocity[1] - command[1]) < 0.1;
    met = meets ? [...met, { steps: result.steps, used }] : [];
    console.log(JSON.stringify({ seed, cpu: used, wall: (performance.now() - clock) / 1000, ...result, velocity },
      (_, value) => (typeof value === 'number' ? Number(value.toPrecision(4)) : value)));
    if (met.length === KEPT || used > limit) resolve();
  }));
  threads.forEach((thread) => thread.terminate());
  const how = met.length === KEPT ? `met from ${met[0].steps} steps and ${met[0].used.toFixed(1)} s of processor time on` : 'not met';
  console.log(`seed ${seed}, ${workers} workers: ${command[0]} m/s ${how}`);
}

if (isMainThread) {
  const [file, workers = '1', seeds = '0', limit = '480'] = process.argv.slice(2);
  const page = JSON.parse(fs.readFileSync(file, 'utf8'));
  for (const seed of seeds.split(',')) await measure(page, Number(workers), Number(seed), Number(limit));
} else {
  const { page, settings, ports } = workerData;
  for await (const result of learn(await loadMujoco(wasm), page, settings, ports)) {
    if (ports[0] === null) parentPort.postMessage(result);
  }
}
