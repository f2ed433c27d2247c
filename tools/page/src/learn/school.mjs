// The workers that learn, seen from the page.

/** Number of workers: the page keeps one processor to draw; more than eight would wait for each other. */
export const workerCount = (processors = navigator.hardwareConcurrency ?? 2) => Math.max(1, Math.min(8, processors - 1));

export class School {
  /**
   * Start to learn.
   * @param source text of the worker's script
   * @param wasm bytes of MuJoCo's WebAssembly module
   * @param content the page's document
   * @param settings see `learn`
   * @param report called with each result of `learn`, or with `{error}`
   */
  constructor(source, wasm, { terrains, robot, control, learning }, settings, report, count = workerCount()) {
    Object.assign(this, { settings, paused: false });
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    this.workers = Array.from({ length: count }, () => new Worker(url));
    const ports = this.workers.map(() => Array(count).fill(null));
    for (let a = 0; a < count; a++) {
      for (let b = 0; b < a; b++) {
        const { port1, port2 } = new MessageChannel();
        [ports[a][b], ports[b][a]] = [port1, port2];
      }
    }
    const ground = terrains.filter(({ heights }) => !heights).slice(0, 1);
    this.workers.forEach((worker, i) => {
      worker.onmessage = ({ data }) => report(data);
      worker.onerror = ({ message }) => report({ error: message ?? 'a worker does not start' });
      const content = { terrains: ground, robot, control, learning };
      worker.postMessage({ wasm, content, settings, ports: ports[i] }, ports[i].filter(Boolean));
    });
  }

  /** Change the settings while it learns. */
  set(settings) {
    Object.assign(this.settings, settings);
    this.send();
  }

  setPaused(paused) {
    this.paused = paused;
    this.send();
  }

  send() {
    for (const worker of this.workers) worker.postMessage({ settings: this.settings, paused: this.paused });
  }

  stop() {
    for (const worker of this.workers) worker.terminate();
  }
}
