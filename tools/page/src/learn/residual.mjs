// The policy that is learned: a network's action added to a gait that marches on the spot.

const TAU = 2 * Math.PI;

/** A policy for a `Walker`, with the interface of a `Graph`. */
export class Residual {
  /**
   * @param learning numbers of the robot and its gait; see `learning_document` in quadruped_env/walking_page/document.py
   */
  constructor(learning) {
    Object.assign(this, { learning, inputs: {} });
    /** Function of an observation (width,) that returns the action (J,). */
    this.act = null;
    this.observation = new Float32Array(learning.observations.reduce((sum, { width }) => sum + width, 0));
    this.out = {
      action: new Float32Array(learning.stance.length),
      joint_target: new Float32Array(learning.stance.length),
      next_gait_phase: new Float32Array(1),
    };
  }

  /** As `ObservationLayout`: fields side by side, scaled and clipped. */
  observe(inputs) {
    const { observations, stance } = this.learning, phase = inputs.gait_phase[0];
    let at = 0;
    for (const { name, width, scale, low, high } of observations) {
      const values = name === 'gait_clock' ? [Math.sin(phase), Math.cos(phase)] : inputs[name];
      for (let i = 0; i < width; i++) {
        const value = (name === 'joint_position' ? values[i] - stance[i] : values[i]) * (scale[i] ?? scale);
        this.observation[at++] = Math.min(high, Math.max(low, value));
      }
    }
    return this.observation;
  }

  run(inputs) {
    const { phases, sine, cosine, offset, low, high, scale, phase_step: step } = this.learning;
    const { action, joint_target: target, next_gait_phase: next } = this.out, wanted = this.act(this.observe(inputs));
    next[0] = (inputs.gait_phase[0] + step) % TAU;
    for (let j = 0; j < target.length; j++) {
      action[j] = Math.min(1, Math.max(-1, wanted[j]));
      const angle = next[0] + phases[j];
      const joint = offset[j] + sine[j] * Math.sin(angle) + cosine[j] * Math.cos(angle) + scale * action[j];
      target[j] = Math.min(high[j], Math.max(low[j], joint));
    }
    return this.out;
  }
}
