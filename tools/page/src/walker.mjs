// A robot with its policy: command, gait clock and what a policy remembers, as quadruped_env/control/ has them.

const TAU = 2 * Math.PI;
/** The scripted gait's swing, an inner value of the graph. */
const SWING = 'gait_swing';

export class Walker {
  /**
   * @param simulation a `Simulation`
   * @param graph a `Graph`, from readings to joint targets
   * @param control `{timestep, command_rate}`: s, and the command's largest rates, one per velocity
   */
  constructor(simulation, graph, control) {
    Object.assign(this, { simulation, graph, control });
    /** Factors on the gait's swing and on the clock's frequency. */
    this.amplitude = this.frequency = 1;
    this.reset();
  }

  /** Begin again at positions in MuJoCo's order, with a command (forward, turn and, if the robot can, left) that holds at once. */
  reset(qpos, command = this.control.command_rate.map(() => 0)) {
    this.simulation.reset(qpos);
    this.command = Float64Array.from(command);
    this.requested = [...command];
    this.memory = {
      last_action: new Float32Array(this.simulation.play.length),
      gait_phase: Float32Array.of(0),
      observation_history: new Float32Array(this.graph.inputs.observation_history?.length ?? 0).fill(NaN),
    };
    this.time = 0;
  }

  /** The graph's inputs at present. */
  inputs() {
    const { simulation } = this;
    return {
      projected_gravity: simulation.projectedGravity(),
      angular_velocity: simulation.reading('angular_velocity_b'),
      joint_position: simulation.reading('joint_position'),
      joint_velocity: simulation.reading('joint_velocity'),
      command: this.command,
      ...this.memory,
    };
  }

  /** Advance one control step. */
  step() {
    const { simulation, graph, memory, frequency } = this;
    const out = graph.run(this.inputs(), { [SWING]: this.amplitude });
    if (out.action) memory.last_action.set(out.action);
    if (out.next_observation_history) memory.observation_history.set(out.next_observation_history);
    if (out.next_gait_phase) {
      const advance = (out.next_gait_phase[0] - memory.gait_phase[0] + TAU) % TAU;
      memory.gait_phase[0] = frequency === 1 ? out.next_gait_phase[0] : (memory.gait_phase[0] + frequency * advance) % TAU;
    }
    simulation.step(out.joint_target);
    // As ControlInterface.approach_requested: the command follows the request at a limited rate.
    this.control.command_rate.forEach((rate, i) => {
      const missing = this.requested[i] - this.command[i], most = rate * this.control.timestep;
      this.command[i] = Math.abs(missing) <= most ? this.requested[i] : this.command[i] + Math.sign(missing) * most;
    });
    this.time += this.control.timestep;
  }
}
