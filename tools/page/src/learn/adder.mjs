// Sums over the workers, which have no memory in common: pages from the disk get none.

/**
 * Function that adds an array over all workers, in their order, so that each of them has the same bits.
 * @param ports message port to each worker, null for this one
 */
export function adder(ports) {
  const arrived = ports.map(() => []), waiting = ports.map(() => null);
  ports.forEach((port, i) => {
    if (!port) return;
    port.onmessage = ({ data }) => {
      if (waiting[i]) waiting[i](data);
      else arrived[i].push(data);
      waiting[i] = null;
    };
  });
  const next = (i) => arrived[i].shift() ?? new Promise((resolve) => { waiting[i] = resolve; });
  return async (values) => {
    for (const port of ports) port?.postMessage(values);
    const total = new Float32Array(values.length);
    for (const one of await Promise.all(ports.map((port, i) => (port ? next(i) : values)))) {
      for (let k = 0; k < total.length; k++) total[k] += one[k];
    }
    return total;
  };
}
