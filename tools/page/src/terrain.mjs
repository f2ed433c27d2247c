// A terrain of the page's document: its MJCF, its heights, and the height of the ground at a point.

const LEVELS = 2 ** 16 - 1;

export class Terrain {
  constructor({ name, xml, heights }) {
    Object.assign(this, { name, xml, grid: heights ?? null, heights: null });
    if (heights) {
      const levels = new Uint16Array(Uint8Array.from(atob(heights.data), (c) => c.charCodeAt(0)).buffer);
      /** Heights in [0, 1] by rows along x, for MuJoCo's height field. */
      this.heights = Float32Array.from(levels, (level) => level / LEVELS);
    }
  }

  /** Height of the highest point of the ground within a distance of a place, m. */
  highest(x, y, distance) {
    if (!this.grid) return 0;
    const { shape: [rows, columns], extent, lowest, span } = this.grid;
    const column = (value) => ((value + extent[0] / 2) / extent[0]) * (columns - 1);
    const row = (value) => ((value + extent[1] / 2) / extent[1]) * (rows - 1);
    let found = -Infinity;
    for (let i = Math.max(0, Math.floor(row(y - distance))); i <= Math.min(rows - 1, Math.ceil(row(y + distance))); i++) {
      for (let j = Math.max(0, Math.floor(column(x - distance))); j <= Math.min(columns - 1, Math.ceil(column(x + distance))); j++) {
        found = Math.max(found, this.heights[i * columns + j]);
      }
    }
    return found === -Infinity ? 0 : lowest + span * found;
  }
}
