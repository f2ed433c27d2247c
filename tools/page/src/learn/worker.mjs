// A Web Worker that learns together with others; see `School`.

import { loadMujoco } from '../simulation.mjs';
import { learn } from './learner.mjs';

let settings = null, gate = null, open = null;

async function run(wasm, content, ports) {
  for await (const result of learn(await loadMujoco(wasm), content, settings, ports)) {
    if (ports[0] === null) postMessage(result);  // the first one speaks for all
    await gate;
    await new Promise((resolve) => { setTimeout(resolve); });  // else a single worker would get no message
  }
}

onmessage = ({ data }) => {
  if (data.ports) {
    settings = data.settings;
    run(data.wasm, data.content, data.ports).catch((error) => postMessage({ error: error.message ?? String(error) }));
  } else {
    Object.assign(settings, data.settings);
    open?.();
    gate = data.paused ? new Promise((resolve) => { open = resolve; }) : null;
  }
};
