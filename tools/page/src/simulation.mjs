// The robot on its ground in MuJoCo's WebAssembly build, stepped as quadruped_env/simulation/single_simulation.py does.

import load from '@mujoco/mujoco';

/** Load MuJoCo from the bytes of its WebAssembly module. */
export const loadMujoco = (wasmBinary) => load({ wasmBinary });

/** Rotation matrix of a quaternion wxyz, by rows. */
export function rotation([w, x, y, z]) {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
  ];
}

/** Heading of a quaternion wxyz, rad. */
export const yawOf = ([w, x, y, z]) => Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));

/** A number rounded to the nearest integer, and a half to the even one, as NumPy's rint does. */
const rint = (x) => (Math.abs(x % 1) === 0.5 ? 2 * Math.round(x / 2) : Math.round(x));

/** Model of an MJCF that may name files, such as meshes: base64 by name. */
function compiled(mujoco, xml, files) {
  const stored = new mujoco.MjVFS();
  for (const [name, text] of Object.entries(files)) stored.addBuffer(name, Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
  const model = mujoco.MjModel.from_xml_string(xml, stored);
  stored.delete();
  return model;
}

export class Simulation {
  /**
   * @param mujoco result of `loadMujoco`
   * @param scene `{xml, heights}`: MJCF, and the height field's heights in [0, 1], or null on a plane
   * @param robot description of the robot; see `quadruped_env/walking_page/document.py`
   */
  constructor(mujoco, scene, robot) {
    this.mujoco = mujoco;
    this.robot = robot;
    this.model = compiled(mujoco, scene.xml, robot.files);
    if (scene.heights) this.model.hfield_data.set(scene.heights);
    this.data = new mujoco.MjData(this.model);
    this.base = mujoco.mj_name2id(this.model, mujoco.mjtObj.mjOBJ_BODY.value, robot.base);
    this.gravity = Math.hypot(...this.model.opt.gravity);
    this.compiled = { mass: this.model.body_mass[this.base], inertia: this.model.body_inertia.slice(3 * this.base, 3 * this.base + 3) };
    this.play = new Float64Array(robot.start.length - 7);
    this.reset();
  }

  /** Free the memory, which WebAssembly does not collect. */
  delete() {
    this.data.delete();
    this.model.delete();
  }

  /** Set positions in MuJoCo's order (7 + J); at rest, with the motors holding them. */
  reset(qpos = this.robot.start) {
    const { mujoco, model, data } = this, joints = qpos.slice(7);
    mujoco.mj_resetData(model, data);
    data.qpos.set(qpos);
    data.ctrl.set(joints);
    this.play.set(joints);
    if (model.nhistory) {
      // As fill_command_history in quadruped_env/robot/motors.py: the motors' delayed targets were constant before.
      const { actuator_historyadr: addresses, actuator_history: lengths } = model, columns = lengths.length / model.nu;
      joints.forEach((position, i) => {
        const start = addresses[i] + 2 + lengths[columns * i];
        if (addresses[i] >= 0) data.history.fill(position, start, start + lengths[columns * i]);
      });
    }
    mujoco.mj_forward(model, data);
    this.settled = true;
  }

  /** Advance one control step with joint targets (J), rad. */
  step(target) {
    const { mujoco, model, data, robot } = this;
    data.ctrl.set(robot.servo ? this.servoTarget(target) : target);
    for (let i = 0; i < robot.decimation; i++) {
      // The last step ended after the first half of a physics step, so that its readings are current.
      if (!this.settled) mujoco.mj_step1(model, data);
      mujoco.mj_step2(model, data);
      mujoco.mj_step1(model, data);
      this.settled = true;
    }
  }

  /** As servo_target in quadruped_env/robot/motors.py. */
  servoTarget(target) {
    const { target_step: step, backlash, dead_band: band } = this.robot.servo, position = this.reading('joint_position');
    return Array.from(target, (value, i) => {
      const rounded = step[i] > 0 ? step[i] * rint(value / step[i]) : value;
      this.play[i] = Math.min(Math.max(this.play[i], rounded - backlash[i] / 2), rounded + backlash[i] / 2);
      const error = this.play[i] - position[i];
      return this.play[i] - Math.min(Math.max(error, -band[i]), band[i]);
    });
  }

  /** A field of quadruped_env/robot/readings.py, a copy. */
  reading(name) {
    return this.data.sensordata.slice(...this.robot.columns[name]);
  }

  /** Unit vector of gravity in the base frame. */
  projectedGravity() {
    const r = rotation(this.reading('orientation')), g = this.model.opt.gravity;
    return [0, 1, 2].map((i) => (r[i] * g[0] + r[3 + i] * g[1] + r[6 + i] * g[2]) / this.gravity);
  }

  /** Position of the base's frame, m. */
  position() {
    return this.data.qpos.slice(0, 3);
  }

  /** Heading, rad. */
  yaw() {
    return yawOf(this.data.qpos.slice(3, 7));
  }

  /** True after the robot has tipped over, lies on its base, or the simulation has diverged. */
  fallen() {
    return !(this.projectedGravity()[2] < -0.5) || this.reading('trunk_force')[0] > 0 || !Number.isFinite(this.data.qpos[0]);
  }

  /** Add a velocity (3) in the world frame to the base, m/s. */
  push(velocity) {
    const { qvel } = this.data;
    velocity.forEach((value, i) => { qvel[i] += value; });
    this.settled = false;
  }

  /** Coefficient of sliding friction of the ground and the robot. */
  setFriction(value) {
    const { geom_friction: friction } = this.model;
    for (let i = 0; i < friction.length; i += 3) friction[i] = value;
    this.settled = false;
  }

  /** Mass on the base, of its shape, kg. */
  setPayload(kilograms) {
    const { mujoco, model, base, compiled } = this, mass = compiled.mass + kilograms;
    model.body_mass[base] = mass;
    compiled.inertia.forEach((value, i) => { model.body_inertia[3 * base + i] = (value * mass) / compiled.mass; });
    // In data of its own, because it moves the robot to its zero position.
    const scratch = new mujoco.MjData(model);
    mujoco.mj_setConst(model, scratch);
    scratch.delete();
    this.settled = false;
  }

  /** Tilt the ground, so that it rises along x by an angle, rad; gravity turns in its place. */
  setSlope(angle) {
    this.model.opt.gravity.set([-this.gravity * Math.sin(angle), 0, -this.gravity * Math.cos(angle)]);
    this.settled = false;
  }
}
