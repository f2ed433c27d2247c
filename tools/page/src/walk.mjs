// The robots of the page, their world and their settings, without any drawing or controls.

import { Graph } from './policy.mjs';
import { Simulation } from './simulation.mjs';
import { Terrain } from './terrain.mjs';
import { Walker } from './walker.mjs';

/** Distance between two robots next to each other, relative to the robot's size, m. */
const LANE = 0.56;
/** Time on the ground after which a fallen robot stands up again, s. */
const DOWN = 1.5;
/** Time over which the shown velocity is averaged, s. */
const SMOOTH = 0.3;

export class Walk {
  /** @param mujoco result of `loadMujoco`; @param content the page's document */
  constructor(mujoco, content) {
    Object.assign(this, { mujoco, content, scale: content.robot.scale, walkers: [] });
    this.terrains = content.terrains.map((terrain) => new Terrain(terrain));
    this.settings = this.standard();
    this.compare = false;
    this.request = [0, 0];
    this.rebuild();
  }

  /** Settings to begin with. */
  standard() {
    return {
      terrain: this.content.terrain, slope: 0, friction: null, payload: 0, amplitude: 1, frequency: 1,
    };
  }

  get terrain() {
    return this.terrains.find(({ name }) => name === this.settings.terrain);
  }

  /** Make the robots again, for another terrain or number of them. */
  rebuild() {
    for (const { simulation } of this.walkers) simulation.delete();
    const { mujoco, content, terrain } = this, graphs = this.compare && content.gait ? [content.policy, content.gait] : [content.policy];
    this.walkers = graphs.map((graph) => new Walker(new Simulation(mujoco, terrain, content.robot), new Graph(graph), content.control));
    this.reset();
  }

  /** Put the robots at the start. */
  reset() {
    this.apply();
    const { height } = this.content.robot;
    this.walkers.forEach((walker, i) => {
      const y = this.walkers.length > 1 ? (i - 0.5) * LANE * this.scale : 0, start = [...this.content.robot.start];
      start[1] = y;
      start[2] = height + this.terrain.highest(0, y, 0.2 * this.scale);
      walker.reset(start);
      Object.assign(walker, { downFor: 0, travelled: 0, speed: 0, rate: 0, falls: 0 });
    });
    this.time = 0;
  }

  /** Apply the settings to every robot. */
  apply() {
    const { slope, friction, payload, amplitude, frequency } = this.settings;
    for (const walker of this.walkers) {
      Object.assign(walker, { amplitude, frequency });
      walker.simulation.setSlope(slope);
      walker.simulation.setPayload(payload);
      if (friction !== null) walker.simulation.setFriction(friction);
    }
  }

  /** Advance all robots by a control step. */
  step() {
    const { timestep } = this.content.control;
    this.time += timestep;
    for (const walker of this.walkers) {
      const { simulation } = walker, [x, y] = simulation.position();
      walker.requested = [...this.request];
      walker.step();
      const [forward] = simulation.reading('linear_velocity_b'), at = simulation.position();
      const [, , rate] = simulation.reading('angular_velocity_b');
      const share = timestep / SMOOTH;
      walker.speed += share * (forward - walker.speed);
      walker.rate += share * (rate - walker.rate);
      walker.travelled += Math.hypot(at[0] - x, at[1] - y);
      walker.downFor = simulation.fallen() ? walker.downFor + timestep : 0;
      if (walker.downFor > DOWN) this.standUp(walker);
    }
  }

  /** Let a robot stand up where it is. */
  standUp(walker) {
    const { simulation, travelled, falls } = walker, start = [...this.content.robot.start];
    const [x, y] = simulation.position(), yaw = simulation.yaw();
    if (Number.isFinite(x + y + yaw)) {
      [start[0], start[1], start[3], start[6]] = [x, y, Math.cos(yaw / 2), Math.sin(yaw / 2)];
      start[2] = this.content.robot.height + this.terrain.highest(x, y, 0.2 * this.scale);
    }
    walker.reset(start);
    Object.assign(walker, { downFor: 0, travelled, speed: 0, rate: 0, falls: falls + 1 });
  }

  /** Contacts of the feet of a robot, as booleans. */
  contacts(index = 0) {
    return Array.from(this.walkers[index].simulation.reading('foot_force'), (force) => force > this.content.robot.contact);
  }
}

/**
 * Repeat the walk of the document's `reference`, and compare its end with Python's.
 * @returns a function that advances by some control steps; it returns the result once it is done, else null
 */
export function comparison(mujoco, content) {
  const { start, command, steps, end } = content.reference;
  const terrain = new Terrain(content.terrains.find(({ heights }) => !heights));
  const simulation = new Simulation(mujoco, terrain, content.robot);
  const walker = new Walker(simulation, new Graph(content.policy), content.control);
  walker.reset(start, command);
  let left = steps;
  return (some) => {
    for (; some > 0 && left > 0; some--, left--) walker.step();
    if (left) return null;
    const [here, there] = [simulation.position(), end].map(([x, y]) => Math.hypot(x, y));
    const result = { seconds: steps * content.control.timestep, speed: command[0], here, there };
    simulation.delete();
    return result;
  };
}
