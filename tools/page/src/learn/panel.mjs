// The part of the page in which the robot learns: buttons, numbers, the learning curve, and the reward to change.

import { say } from '../texts.mjs';
import { ActorCritic } from './ppo.mjs';
import { Residual } from './residual.mjs';
import { School, workerCount } from './school.mjs';

const $ = (id) => document.getElementById(id);
/** Time over which the robot on the page has to keep the commanded speed, and how well: s and m/s, of the built-in one. */
const KEPT = { seconds: 4, tolerance: 0.05 };
/** Largest yaw rate to learn, as a part of the commands' largest. */
const TURN = 0.6;
const COLOURS = { speed: '#0072b2', reward: '#009e73', zero: '#8a94a0', text: '#57616d' };

export class LearningPanel {
  /** @param page the page; @param source text of the worker's script; @param wasm bytes of MuJoCo's module */
  constructor(page, source, wasm) {
    const { learning } = page.walk.content;
    Object.assign(this, { page, source, wasm, school: null, policy: null });
    $('learn').hidden = !learning;
    if (!learning) return;
    this.policy = new Residual(learning);
    this.agent = ActorCritic.of(this.policy);
    this.policy.act = (observation) => this.agent.mean(observation);
    this.clear();
    const { unit, command, weights } = learning, [, fastest] = page.walk.content.control.forward;
    /** Each slider: range, step, value and its text. The values are whole steps, or the browser would round them. */
    this.sliders = {
      learn_speed: [fastest / 6, fastest, fastest / 12, command[0], (v) => `${v.toFixed(2)} m/s`],
      learn_lift: [0, 2, 0.1, 1, (v) => `${(v * weights.gait_clock).toFixed(0)}`],
      learn_smooth: [0, 10, 0.5, 1, (v) => `${(v * weights.action_rate).toFixed(1)}`],
    };
    for (const [id, [min, max, step, value, text]] of Object.entries(this.sliders)) {
      const input = $(id), output = input.closest('label').querySelector('output');
      Object.assign(input, { min, max, step, value });
      output.textContent = text(input.valueAsNumber);
      input.addEventListener('input', () => { output.textContent = text(input.valueAsNumber); this.change(); });
    }
    $('learn_turn').addEventListener('change', () => this.change());
    $('learn_go').addEventListener('click', () => this.go());
    $('learn_again').addEventListener('click', () => this.stop());
    this.tolerance = KEPT.tolerance * unit[0];
  }

  clear() {
    Object.assign(this, { results: [], seconds: 0, since: null, reached: null, average: 0, error: null });
  }

  /** What is learned, from the sliders. */
  settings() {
    const { weights } = this.policy.learning, { control } = this.page.walk.content;
    return {
      command: [$('learn_speed').valueAsNumber, 0],
      turns: $('learn_turn').checked ? TURN * control.turn[1] : null,
      weights: {
        ...weights, gait_clock: weights.gait_clock * $('learn_lift').valueAsNumber,
        action_rate: weights.action_rate * $('learn_smooth').valueAsNumber,
      },
    };
  }

  change() {
    const settings = this.settings();
    this.school?.set(settings);
    if (this.school) this.page.learned(this.policy, settings);
  }

  // --- actions

  /** Start, pause or go on. */
  go() {
    if (!this.school) {
      this.clear();
      this.agent.parameters.fill(0);
      this.school = new School(this.source, this.wasm, this.page.walk.content, { seed: 0, ...this.settings() }, (result) => this.take(result));
      this.page.learned(this.policy, this.settings());
    } else {
      this.tick();
      this.school.setPaused(!this.school.paused);
    }
    this.since = this.school.paused || !this.results.length ? null : performance.now();
    this.translate();
  }

  /** Forget all that was learned, and let the page's own policy walk again. */
  stop() {
    this.school?.stop();
    this.school = null;
    this.clear();
    this.page.learned(null);
    this.translate();
  }

  take(result) {
    if (result.error) {
      this.error = result.error;
      this.school.stop();
      return this.translate();
    }
    // Workers need some time to start, in which nothing is learned.
    if (this.results.length) this.tick();
    else this.since = performance.now();
    this.results.push({ ...result, actor: null, seconds: this.seconds });
    this.agent.actorParameters.set(result.actor);
    this.translate();
  }

  /** Count the time of learning, without pauses. */
  tick() {
    const now = performance.now();
    if (this.since !== null) this.seconds += (now - this.since) / 1000;
    this.since = this.school?.paused ? null : now;
  }

  /** Watch the robot on the page after a control step: it acts without noise. */
  watch(walker, timestep) {
    if (!this.school || this.reached !== null) return;
    const share = timestep / (KEPT.seconds / 4), command = walker.command[0];
    this.average += share * (walker.speed - this.average);
    const near = Math.abs(this.average - command) < this.tolerance && Math.abs(walker.rate) < 2 * this.tolerance;
    this.kept = near && !walker.downFor ? (this.kept ?? 0) + timestep : 0;
    if (this.kept > KEPT.seconds) {
      this.reached = this.seconds;
      this.translate();
    }
  }

  // --- what is shown

  translate() {
    if (!this.policy) return;
    const { page: { language }, school, results } = this, words = (key, ...values) => say(language, key, ...values);
    $('learn_go').textContent = words(!school ? 'learn_start' : school.paused ? 'learn_continue' : 'learn_pause');
    $('learn_again').hidden = !school;
    $('learn_curve').hidden = $('learn_numbers').hidden = !results.length;
    const last = results.at(-1), first = results[0];
    $('learn_state').textContent = this.error ? words('failed', this.error)
      : !school || school.paused ? words('learn_workers', workerCount()) : !last ? words('learn_starting', workerCount())
        : this.reached !== null ? words('learn_reached', this.reached.toFixed(0), school.settings.command[0].toFixed(2))
          : words('learn_running', workerCount());
    if (!last) return;
    $('learn_numbers').textContent = words('learn_numbers', this.seconds.toFixed(0), last.steps.toLocaleString(language),
      (last.steps / Math.max(1, this.seconds)).toFixed(0), last.noise.toFixed(2));
    this.draw([
      { name: words('learn_curve_speed'), values: results.map(({ speed }) => speed), zero: first.speed, goal: school.settings.command[0], colour: COLOURS.speed },
      { name: words('learn_curve_reward'), values: results.map(({ reward }) => reward), zero: first.reward, colour: COLOURS.reward },
    ], words('learn_zero'));
  }

  /** Draw curves below each other over the time of learning. */
  draw(curves, zeroName) {
    const canvas = $('learn_curve'), ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    [canvas.width, canvas.height] = [width * ratio, height * ratio].map(Math.round);
    const pen = canvas.getContext('2d'), each = height / curves.length, left = 34, longest = Math.max(60, this.seconds);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.font = '11px system-ui, sans-serif';
    curves.forEach(({ name, values, zero, goal, colour }, row) => {
      const shown = [...values, zero, goal ?? zero], low = Math.min(0, ...shown), high = Math.max(...shown) * 1.1;
      const top = row * each + 16, bottom = (row + 1) * each - 14;
      const x = (seconds) => left + ((width - left - 4) * seconds) / longest, y = (value) => bottom - ((bottom - top) * (value - low)) / (high - low);
      const line = (value, text, dash, ink) => {
        pen.strokeStyle = pen.fillStyle = ink;
        pen.setLineDash(dash);
        pen.beginPath();
        pen.moveTo(left, y(value));
        pen.lineTo(width - 4, y(value));
        pen.stroke();
        pen.fillText(text, 0, y(value) + 4);
      };
      pen.lineWidth = 1;
      line(zero, zero.toFixed(zero < 1 ? 2 : 0), [4, 3], COLOURS.zero);
      if (goal !== undefined) line(goal, goal.toFixed(2), [1, 2], colour);
      pen.fillStyle = COLOURS.zero;
      pen.textAlign = 'right';
      if (row === 0) pen.fillText(zeroName, width - 4, 11);
      pen.textAlign = 'left';
      pen.setLineDash([]);
      pen.strokeStyle = pen.fillStyle = colour;
      pen.lineWidth = 2;
      pen.beginPath();
      values.forEach((value, i) => pen.lineTo(x(this.results[i].seconds), y(value)));
      pen.stroke();
      pen.fillText(name, left, row * each + 11);
    });
    pen.fillStyle = COLOURS.text;
    pen.fillText('0 s', left, height - 2);
    pen.textAlign = 'right';
    pen.fillText(`${longest.toFixed(0)} s`, width - 4, height - 2);
  }
}
