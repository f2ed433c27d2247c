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
/** Distance at which the robot with the scripted gait is put next to the other one again, relative to the robot's size, m. */
const APART = 1.2;
/** A robot is stuck that moves by less than a share of the commanded distance in this time, s; slower commands do not count, m/s. */
const STUCK = { seconds: 3, share: 0.25, slowest: 0.1 };

export class Walk {
  /** @param mujoco result of `loadMujoco`; @param content the page's document */
  constructor(mujoco, content) {
    Object.assign(this, { mujoco, content, scale: content.robot.scale, walkers: [] });
    this.terrains = content.terrains.map((terrain) => new Terrain(terrain));
    this.settings = this.standard();
    this.compare = false;
    /** Policy that is being learned, which then replaces the page's own; else null. */
    this.learned = null;
    /** Requested forward velocity, yaw rate and, if the robot walks sideways, velocity to the left, m/s and rad/s. */
    this.request = content.control.command_rate.map(() => 0);
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
    const { mujoco, content, terrain } = this, graphs = [this.learned ?? new Graph(content.policy)];
    if (this.compare && content.gait) graphs.push(new Graph(content.gait));
    this.walkers = graphs.map((graph) => new Walker(new Simulation(mujoco, terrain, content.robot), graph, content.control));
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
      Object.assign(walker, { travelled: 0, falls: 0, returned: 0 });
      this.begin(walker);
    });
    this.time = 0;
  }

  /** Begin to measure a robot's motion where it stands. */
  begin(walker) {
    Object.assign(walker, { downFor: 0, speed: 0, rate: 0, left: 0, stuck: false });
    this.watch(walker);
  }

  /** Begin to watch whether a robot gets on. */
  watch(walker) {
    walker.watched = { from: walker.simulation.position(), seconds: 0, commanded: 0 };
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
    const { timestep, lateral } = this.content.control;
    this.time += timestep;
    for (const walker of this.walkers) {
      const { simulation } = walker;
      walker.requested = [...this.request];
      walker.step();
      const [forward, left] = simulation.reading('linear_velocity_b');
      const [, , rate] = simulation.reading('angular_velocity_b');
      const share = timestep / SMOOTH;
      walker.speed += share * (forward - walker.speed);
      walker.rate += share * (rate - walker.rate);
      walker.left += share * (left - walker.left);
      // Not the length of the path: marching on the spot is no distance.
      walker.travelled += Math.hypot(walker.speed, lateral ? walker.left : 0) * timestep;
      walker.downFor = simulation.fallen() ? walker.downFor + timestep : 0;
      this.watchProgress(walker);
      if (walker.downFor > DOWN) this.standUp(walker);
    }
    this.keepTogether();
  }

  /** Find out whether a robot gets on, once in a while. */
  watchProgress(walker) {
    const { watched } = walker, { timestep } = this.content.control;
    watched.seconds += timestep;
    watched.commanded += Math.hypot(walker.command[0], walker.command[2] ?? 0) * timestep;
    if (watched.seconds < STUCK.seconds) return;
    const [x, y] = walker.simulation.position(), moved = Math.hypot(x - watched.from[0], y - watched.from[1]);
    const counts = watched.commanded > STUCK.slowest * this.scale * watched.seconds;
    walker.stuck = counts && moved < STUCK.share * watched.commanded;
    this.watch(walker);
  }

  /** Put the robot with the gait next to the other one, if they are too far apart for one picture. */
  keepTogether() {
    const [robot, other] = this.walkers;
    if (!other) return;
    const [x, y] = robot.simulation.position(), [x2, y2] = other.simulation.position(), yaw = robot.simulation.yaw();
    if (Math.hypot(x2 - x, y2 - y) < APART * this.scale) return;
    other.returned += 1;
    this.place(other, x - LANE * this.scale * Math.sin(yaw), y + LANE * this.scale * Math.cos(yaw), yaw);
  }

  /** Let a robot stand up where it is. */
  standUp(walker) {
    const { simulation } = walker, [x, y] = simulation.position();
    walker.falls += 1;
    this.place(walker, x, y, simulation.yaw());
  }

  /** Let a robot stand at a place with a heading, rad; at the start if they are not finite. */
  place(walker, x, y, yaw) {
    const start = [...this.content.robot.start];
    if (Number.isFinite(x + y + yaw)) {
      [start[0], start[1], start[3], start[6]] = [x, y, Math.cos(yaw / 2), Math.sin(yaw / 2)];
      start[2] = this.content.robot.height + this.terrain.highest(x, y, 0.2 * this.scale);
    }
    walker.reset(start);
    this.begin(walker);
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
