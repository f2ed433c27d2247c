// Sliders, buttons, keys, stick and gamepad. They change the walk and the view, and show their state.

import { say, TEXTS } from './texts.mjs';

const $ = (id) => document.getElementById(id);
const DEGREE = Math.PI / 180;
/** Part of a gamepad's stick around its centre that does not count. */
const DEAD = 0.15;

export class Controls {
  /** @param page the page: `walk`, `view`, and its actions */
  constructor(page) {
    Object.assign(this, { page, held: new Set(), stick: null, gamepad: false });
    const { control, robot, gait, policy } = page.walk.content, [low, high] = control.forward;
    const { walk } = page;
    /** Each slider: range, default, text of its value, and what it changes. */
    this.sliders = {
      limit: [control.key_steps[0], high, high, (v) => `${v.toFixed(2)} m/s`, (v) => { page.limit = v; this.steer(); }],
      strength: [0.1, 1.5, 0.6, (v) => `${(v * Math.sqrt(walk.scale)).toFixed(2)} m/s`, (v) => { page.strength = v * Math.sqrt(walk.scale); }],
      slope: [-12, 12, 0, (v) => `${v.toFixed(0)}°`, (v) => page.set({ slope: v * DEGREE })],
      friction: [0.1, 1.5, robot.friction, (v) => v.toFixed(2), (v) => page.set({ friction: v })],
      payload: [0, robot.mass / 2, 0, (v) => `${v.toFixed(robot.mass < 2 ? 2 : 1)} kg`, (v) => page.set({ payload: v })],
      amplitude: [0, 2, 1, (v) => `${v.toFixed(2)}×`, (v) => page.set({ amplitude: v })],
      frequency: [0.5, 1.5, 1, (v) => `${v.toFixed(2)}×`, (v) => page.set({ frequency: v })],
    };
    for (const [id, [min, max, value, text, act]] of Object.entries(this.sliders)) {
      const input = $(id), shown = input.closest('label').querySelector('output');
      Object.assign(input, { min, max, step: { slope: 1, limit: 'any' }[id] ?? 0.01, value });
      input.addEventListener('input', () => { shown.textContent = text(input.valueAsNumber); act(input.valueAsNumber); });
      shown.textContent = text(value);
    }
    page.limit = high;
    this.limits = { lowest: low, highest: high, turn: control.turn[1], lateral: control.lateral };
    document.body.classList.toggle('sideways', Boolean(control.lateral));
    page.strength = this.sliders.strength[2] * Math.sqrt(walk.scale);
    // Without a clock the policy has no frequency, and without a gait of its own nothing to scale.
    $('frequency').closest('label').hidden = !('gait_phase' in policy.inputs);
    $('amplitude').closest('label').hidden = !policy.nodes.some(([, , output]) => output === 'gait_swing');
    $('gait_hint').hidden = $('amplitude').closest('label').hidden;
    $('gait').hidden = $('frequency').closest('label').hidden && $('amplitude').closest('label').hidden;
    $('beside').hidden = $('beside_hint').hidden = !gait;
    for (const { name } of walk.terrains) $('terrain').append(new Option(name, name, false, name === walk.settings.terrain));
    $('terrain').addEventListener('change', () => page.setTerrain($('terrain').value));
    for (const [id, act] of Object.entries({
      pause: () => page.setPaused(!page.paused), slow: () => page.setSlow(!page.slow), reset: () => page.reset(),
      stop: () => this.stop(), push: () => page.pushSomewhere(), language: () => page.setLanguage(page.language === 'en' ? 'zh' : 'en'),
      standard: () => this.standard(), open: () => this.toggle(),
    })) $(id).addEventListener('click', act);
    $('compare').addEventListener('change', () => page.setCompare($('compare').checked));
    $('follow').addEventListener('change', () => { page.view.follow = $('follow').checked; });
    this.addKeys();
    this.addStick();
    this.addClicks();
  }

  // --- steering: a forward speed that stays, in parts of the limit from -1 to 1; a turn and steps to the left that spring back

  addKeys() {
    const steps = { ArrowUp: 0.2, ArrowDown: -0.2 };
    /** Key -> turn and steps to the left while it is held. */
    const motions = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ...(this.limits.lateral && { q: [0, 1], e: [0, -1] }) };
    const name = (key) => (key.length === 1 ? key.toLowerCase() : key);
    const steer = () => this.steer(undefined, ...[0, 1].map((i) => [...this.held].reduce((sum, key) => sum + motions[key][i], 0)));
    const actions = {
      ' ': () => this.page.setPaused(!this.page.paused), r: () => this.page.reset(), p: () => this.page.pushSomewhere(),
      m: () => this.page.setSlow(!this.page.slow), 0: () => this.stop(),
      c: () => { if (!$('beside').hidden) { $('compare').checked = !$('compare').checked; this.page.setCompare($('compare').checked); } },
    };
    addEventListener('keydown', (event) => {
      const { target } = event, key = name(event.key);
      if (event.ctrlKey || event.metaKey || event.altKey || target.matches('select, input[type=range]')) return;
      if (key === ' ' && target.matches('button, input')) return;
      if (key in steps) this.steer(Math.round(5 * (this.page.throttle + steps[key])) / 5);
      else if (key in motions) { this.held.add(key); steer(); }
      else if (key in actions) actions[key]();
      else return;
      event.preventDefault();
    });
    addEventListener('keyup', ({ key }) => { if (this.held.delete(name(key))) steer(); });
    addEventListener('blur', () => { if (this.held.size) { this.held.clear(); steer(); } });
  }

  /** Steer by a stick's deflection to the right and upwards: it walks sideways, or turns a robot that cannot. */
  steerByStick(x, y, turn) {
    if (this.limits.lateral) this.steer(y, turn, -x);
    else this.steer(y, -x);
  }

  addStick() {
    const stick = $('stick');
    const move = (event) => {
      const { left, top, width, height } = stick.getBoundingClientRect(), reach = 0.36;
      const x = ((event.clientX - left) / width - 0.5) / reach, y = (0.5 - (event.clientY - top) / height) / reach;
      this.steerByStick(Math.abs(x) < DEAD ? 0 : x, Math.abs(y) < DEAD ? 0 : y);
    };
    stick.addEventListener('pointerdown', (event) => { stick.setPointerCapture(event.pointerId); move(event); });
    stick.addEventListener('pointermove', (event) => { if (stick.hasPointerCapture(event.pointerId)) move(event); });
    for (const end of ['pointerup', 'pointercancel']) stick.addEventListener(end, () => this.steer(undefined, 0, 0));
    const turn = $('turn');
    turn.addEventListener('input', () => this.steer(undefined, -turn.valueAsNumber));
    // The keys steer again once it is released.
    turn.addEventListener('change', () => { turn.blur(); this.steer(undefined, 0); });
  }

  /** Read the first gamepad; its sticks spring back, and so does the speed. */
  pollGamepad() {
    const pad = navigator.getGamepads?.().find((found) => found?.connected);
    if (!pad) return;
    const [x, y, turn = 0] = pad.axes.map((value) => (Math.abs(value) < DEAD ? 0 : value)), active = Boolean(x || y || (this.limits.lateral && turn));
    if (active || this.gamepad) this.steerByStick(x, -y, -turn);
    this.gamepad = active;
    const pressed = pad.buttons[0]?.pressed;
    if (pressed && !this.pressed) this.page.pushSomewhere();
    this.pressed = pressed;
  }

  /** Set the forward speed, the turn and the steps to the left, from -1 to 1; what is left out stays. */
  steer(throttle = this.page.throttle, turn = this.page.turn, left = this.page.left) {
    const { page } = this, clip = (value) => Math.min(1, Math.max(-1, value));
    Object.assign(page, { throttle: clip(throttle), turn: clip(turn), left: clip(left) });
    const { lowest, highest, turn: fastest, lateral } = this.limits, forward = page.throttle * page.limit;
    page.walk.request = [Math.min(highest, Math.max(lowest, forward)), page.turn * fastest];
    if (lateral) page.walk.request.push(Math.abs(page.left) * lateral[page.left > 0 ? 1 : 0]);
    const across = lateral ? page.left : page.turn;
    $('knob').style.transform = `translate(${-36 * across}%, ${-36 * page.throttle}%) translate(${-across * 30}px, ${-page.throttle * 30}px)`;
    $('turn').value = -page.turn;
  }

  /** Limit the steering to what a learned policy has learned, `[forward velocity, yaw rate]`; null: to the page's own commands. */
  limitTo(learned) {
    const { forward: [lowest, highest], turn: [, turn], lateral } = this.page.walk.content.control;
    this.limits = learned
      ? { lowest: learned[1] ? 0 : learned[0], highest: learned[0], turn: learned[1] }
      : { lowest, highest, turn, lateral };
    this.steer(learned ? 1 : undefined, 0, 0);
  }

  stop() {
    this.steer(0, 0, 0);
  }

  addClicks() {
    const canvas = $('view'), at = (event) => {
      const { left, top } = canvas.getBoundingClientRect();
      return [event.clientX - left, event.clientY - top];
    };
    let down = null;
    canvas.addEventListener('pointerdown', (event) => { down = at(event); });
    canvas.addEventListener('pointerup', (event) => {
      const [x, y] = at(event);
      if (down && Math.hypot(x - down[0], y - down[1]) < 6) {
        const hit = this.page.view.pick(x, y);
        if (hit) this.page.push(hit.direction, [hit.index]);
      }
      down = null;
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!event.buttons) canvas.classList.toggle('aim', this.page.view.pick(...at(event)) !== null);
    });
  }

  // --- settings

  standard() {
    for (const [id, [, , value, text, act]] of Object.entries(this.sliders)) {
      $(id).value = value;
      $(id).closest('label').querySelector('output').textContent = text(value);
      act(value);
    }
    this.page.set({ friction: null });
    $('terrain').value = this.page.walk.content.terrain;
    this.page.setTerrain($('terrain').value);
  }

  toggle(open = !$('panel').classList.contains('open')) {
    $('panel').classList.toggle('open', open);
    document.body.classList.toggle('sheet', open);
    $('open').setAttribute('aria-expanded', open);
    $('open').textContent = open ? '✕' : '⚙';
    this.page.view.resize();
  }

  // --- what is shown

  /** Write all words in the page's language. */
  translate() {
    const { language, walk, paused } = this.page, words = (key, ...values) => say(language, key, ...values);
    document.documentElement.lang = language === 'zh' ? 'zh-CN' : 'en';
    document.title = words('title');
    for (const element of document.querySelectorAll('[data-text]')) element.textContent = words(element.dataset.text);
    for (const element of document.querySelectorAll('[data-label]')) {
      element.ariaLabel = element.title = words(element.dataset.label);
    }
    for (const option of $('terrain').options) option.textContent = TEXTS[language].terrains[option.value] ?? option.value;
    const { name, versions } = walk.content;
    $('engine').textContent = words('engine', walk.mujoco.mj_versionString());
    $('about').textContent = words('about', name, versions.mini_quadruped);
    this.showPaused(paused);
    this.showCheck();
    this.page.learning.translate();
  }

  showPaused(paused) {
    $('pause').textContent = paused ? '▶' : '❚❚';
    $('pause').title = $('pause').ariaLabel = say(this.page.language, paused ? 'resume' : 'pause');
  }

  showSlow(slow) {
    $('slow').setAttribute('aria-pressed', slow);
  }

  /** Show how far this MuJoCo is from Python's. */
  showCheck() {
    const { page } = this, { language, checked } = page;
    $('check').textContent = checked
      ? say(language, 'check', checked.seconds, checked.speed, checked.here.toFixed(2), checked.there.toFixed(2), page.walk.content.versions.mujoco, (100 * Math.abs(checked.here - checked.there)).toFixed(1))
      : say(language, 'checking');
  }

  /** Show a message, or hide it. */
  tell(key, ...values) {
    $('message').hidden = !key;
    if (key) $('message').textContent = say(this.page.language, key, ...values);
  }

  /** Show the robot's motion. */
  show() {
    const { walk, language } = this.page, [walker] = walk.walkers, number = (value) => value.toFixed(2).replace(/^-(?=0\.00$)/, '');
    const wanted = (value) => `${say(language, 'commanded')} ${number(value)}`;
    $('speed').textContent = `${number(walker.speed)} m/s`;
    $('wanted').textContent = wanted(walker.command[0]);
    $('rate').textContent = `${number(walker.rate)} rad/s`;
    $('wanted_rate').textContent = wanted(walker.command[1]);
    $('left').textContent = `${number(walker.left)} m/s`;
    $('wanted_left').textContent = wanted(walker.command[2] ?? 0);
    $('distance').textContent = `${walker.travelled.toFixed(1)} m`;
    $('time').textContent = `${walk.time.toFixed(1)} s`;
    const [, gait] = walk.walkers;
    $('other').hidden = !gait;
    if (gait) $('other').textContent = say(language, 'other', number(gait.speed), gait.travelled.toFixed(1), gait.falls, walker.falls, gait.returned);
    // A robot that learns may march on the spot.
    this.tell(walker.downFor > 0.1 ? 'fell' : walker.stuck && !walk.learned ? 'stuck' : null);
  }
}
