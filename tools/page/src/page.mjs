// The page that walks: it unpacks what it holds, and plays the robots in real time.

import { Controls } from './controls.mjs';
import { FeetDiagram } from './feet.mjs';
import { LearningPanel } from './learn/panel.mjs';
import { Graph } from './policy.mjs';
import { loadMujoco } from './simulation.mjs';
import { LANGUAGES, preferred, say } from './texts.mjs';
import { View } from './view.mjs';
import { comparison, Walk } from './walk.mjs';

/** Part of the speed limit with which the page begins. */
const THROTTLE = 0.8;
/** Speed of the slow motion. */
const SLOW = 0.25;
/** Longest time that a frame catches up with, s: a page that was in the background does not race. */
const LONGEST = 0.1;
/** Control steps of the comparison with Python per frame. */
const CHECKED = 4;
/** Colour of the robot with the scripted gait. */
const TINT = { colour: 0xd55e00, share: 0.72 };

const $ = (id) => document.getElementById(id);

/** Parts of the window at its edges that lie under cards, pixels. */
function covered() {
  const panel = $('panel').getBoundingClientRect();
  const hud = $('hud').getBoundingClientRect();
  if (panel.left > innerWidth / 2) return { top: 0, right: innerWidth - panel.left, bottom: innerHeight - hud.top };
  const below = panel.width ? panel : $('stick').getBoundingClientRect();
  return { top: hud.bottom, right: 0, bottom: innerHeight - below.top };
}

class Page {
  constructor(mujoco, content, worker, wasm) {
    this.walk = new Walk(mujoco, content);
    Object.assign(this, { language: preferred(), paused: false, slow: false, throttle: 0, turn: 0, left: 0, checked: null });
    this.view = new View($('view'), content.robot, covered);
    this.feet = new FeetDiagram($('feet'), content.robot.legs, content.control.timestep);
    this.controls = new Controls(this);
    this.learning = new LearningPanel(this, worker, wasm);
    this.check = comparison(mujoco, content);
    this.due = 0;
    this.redraw();
    this.controls.translate();
    this.controls.steer(THROTTLE, 0);
  }

  /** Draw the ground and the robots again. */
  redraw() {
    const { walk, view, feet } = this;
    view.setTerrain(walk.terrain);
    view.setSlope(walk.settings.slope);
    view.setRobots(walk.walkers.map(({ simulation }) => simulation), [null, TINT]);
    feet.clear();
  }

  // --- actions

  setPaused(paused) {
    this.paused = paused;
    this.controls.showPaused(paused);
  }

  setSlow(slow) {
    this.slow = slow;
    this.controls.showSlow(slow);
  }

  setLanguage(language) {
    this.language = language;
    this.controls.translate();
  }

  /** Change settings of the world or the robots; see `Walk.standard`. */
  set(settings) {
    Object.assign(this.walk.settings, settings);
    this.walk.apply();
    this.view.setSlope(this.walk.settings.slope);
  }

  setTerrain(terrain) {
    this.walk.settings.terrain = terrain;
    this.walk.rebuild();
    this.redraw();
  }

  setCompare(compare) {
    this.walk.compare = compare;
    this.walk.rebuild();
    this.redraw();
    this.controls.show();
    this.view.resize();  // the card with the numbers has one more line
    this.view.resetCamera(compare ? 1.25 : 1);
  }

  /**
   * Let the robot walk with a policy that is being learned, or with the page's own again.
   * @param policy a `Residual`, or null
   * @param settings what it learns, which limits the steering
   */
  learned(policy, settings) {
    const { walk, controls } = this;
    controls.limitTo(policy && [settings.command[0], settings.turns ?? 0]);
    if (policy === walk.learned) return;
    walk.learned = policy;
    walk.rebuild();
    this.redraw();
  }

  reset() {
    this.walk.reset();
    this.redraw();
    this.view.resetCamera();
  }

  /** Push robots in a horizontal direction of the world, which is a unit vector. */
  push(direction, robots) {
    for (const index of robots) this.walk.walkers[index].simulation.push(direction.map((part) => part * this.strength));
    this.view.showPush(robots[0], direction);
  }

  pushSomewhere() {
    const angle = 2 * Math.PI * Math.random();
    this.push([Math.cos(angle), Math.sin(angle), 0], [...this.walk.walkers.keys()]);
  }

  // --- time

  /** Advance by a number of control steps, whatever the clock says. */
  step(count = 1) {
    for (let i = 0; i < count; i++) {
      this.walk.step();
      this.view.record();
      this.feet.record(this.walk.contacts());
      this.learning.watch(this.walk.walkers[0], this.walk.content.control.timestep);
    }
  }

  /** Go on with the comparison with Python by some control steps. */
  compare(steps) {
    if (this.checked) return;
    this.checked = this.check(steps);
    if (this.checked) this.controls.showCheck();
  }

  frame(seconds) {
    const { timestep } = this.walk.content.control;
    this.controls.pollGamepad();
    if (!this.paused) {
      this.due += Math.min(seconds, LONGEST) * (this.slow ? SLOW : 1);
      const steps = Math.floor(this.due / timestep);
      this.step(steps);
      this.due -= steps * timestep;
    }
    this.compare(CHECKED);
    this.view.draw(this.due / timestep, seconds);
    this.feet.draw();
    this.controls.show();
  }

  run() {
    let last = performance.now();
    const frame = (now) => {
      this.frame(Math.max(0, now - last) / 1000);
      last = now;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }
}

/** Bytes of a gzipped part of the page. */
async function part(id) {
  const bytes = Uint8Array.from(atob($(id).textContent.trim()), (c) => c.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

/** Say in every language why the page cannot run, and hide all else. */
function fail(key, ...values) {
  document.body.classList.add('failed');
  $('message').replaceChildren(...Object.keys(LANGUAGES).map(
    (lang) => Object.assign(document.createElement('p'), { lang, textContent: say(lang, key, ...values) }),
  ));
  $('message').hidden = false;
}

async function start() {
  Object.assign($('message'), { hidden: false, textContent: say(preferred(), 'loading') });
  const content = JSON.parse(new TextDecoder().decode(await part('document')));
  const wasm = await part('wasm'), worker = new TextDecoder().decode(await part('worker'));
  const page = new Page(await loadMujoco(wasm), content, worker, wasm);
  // For tests, and for readers with a console.
  window.quadruped = { page, walk: page.walk, Graph, Walk };
  page.run();
}

if (!document.createElement('canvas').getContext('webgl2')) fail('no_webgl');
else {
  start().catch((error) => {
    fail('failed', error.message ?? error);
    throw error;
  });
}
