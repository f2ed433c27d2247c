// The contact diagram: a bar for each foot while it is on the ground, over the last seconds.

const SECONDS = 2.5, INK = '#57616d', LINE = '#e3e8ee';

export class FeetDiagram {
  /** @param canvas where to draw; @param legs `{name, colour}` of each leg; @param timestep time between records, s */
  constructor(canvas, legs, timestep) {
    Object.assign(this, { canvas, legs, length: Math.round(SECONDS / timestep), history: [] });
  }

  clear() {
    this.history = [];
  }

  /** Add the contacts of all feet after a control step, as booleans. */
  record(contacts) {
    this.history.push(contacts);
    if (this.history.length > this.length) this.history.shift();
  }

  draw() {
    const { canvas, legs, history, length } = this, ratio = devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width) return;
    const size = [width * ratio, height * ratio].map(Math.round);
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    const pen = canvas.getContext('2d'), left = 26, row = height / legs.length, dx = (width - left) / length;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = '11px system-ui, sans-serif';
    pen.textBaseline = 'middle';
    legs.forEach(({ name, colour }, leg) => {
      const top = leg * row + 0.18 * row, thick = 0.64 * row, first = length - history.length;
      pen.fillStyle = INK;
      pen.fillText(name.slice(0, 3), 0, leg * row + row / 2);
      pen.fillStyle = LINE;
      pen.fillRect(left, top, width - left, thick);
      pen.fillStyle = colour;
      for (let i = 0; i < history.length; i++) {
        if (!history[i][leg]) continue;
        let end = i;
        while (end + 1 < history.length && history[end + 1][leg]) end++;
        pen.fillRect(left + (first + i) * dx, top, (end - i + 1) * dx, thick);
        i = end;
      }
    });
  }
}
