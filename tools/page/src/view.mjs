// Drawing with three.js: the ground, robots made of the model's geoms, and a camera that follows.

import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';

const BACKGROUND = 0xdce6f0, FLOOR = ['#edf1f6', '#cfd7e1'], PUSH = 0xe69f00;
/** Side length of the floor's squares, m. */
const SQUARE = 0.5;
/** Space around robots in the picture, relative to the robot's size, m. */
const MARGIN = 0.3;
/** Mean time of a frame from which on fewer pixels are drawn, s. */
const SLOW_FRAME = 0.05;
/** MuJoCo's types of geoms that have a shape of their own. */
const [SPHERE, CAPSULE, ELLIPSOID, CYLINDER, BOX, MESH] = [2, 3, 4, 5, 6, 7];
/** First of the groups that MuJoCo's viewer hides: shapes for contacts. */
const HIDDEN_GROUP = 3;

export class View {
  /**
   * @param canvas where to draw
   * @param robot the document's description of the robot
   * @param covered function that returns the parts of the canvas that lie under cards, `{top, right, bottom}`, pixels
   */
  constructor(canvas, robot, covered) {
    const { scale } = robot;
    Object.assign(this, { canvas, robot, scale, covered, follow: true, robots: [] });
    this.target = new THREE.Vector3(0, 0, robot.height);
    /** From the robot to the middle between two that the camera follows. */
    this.aside = new THREE.Vector3();
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    Object.assign(this, { frames: 0, frameTime: 0 });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(BACKGROUND);
    this.scene.fog = new THREE.Fog(BACKGROUND, 4 * scale, 16 * scale);
    this.scene.environment = new THREE.PMREMGenerator(this.renderer).fromScene(new RoomEnvironment(), 0.04).texture;
    this.scene.environmentIntensity = 0.62;
    /** Everything on the ground; it tilts with the slope. */
    this.world = this.scene.add(new THREE.Group()).children.at(-1);
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.01 * scale, 60 * scale);
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    Object.assign(this.orbit, {
      enableDamping: true, enablePan: false, minDistance: 0.3 * scale, maxDistance: 6 * scale, maxPolarAngle: 1.52,
    });
    this.resetCamera();
    this.light = new THREE.DirectionalLight(0xffffff, 2.8);
    this.light.castShadow = true;
    this.light.shadow.mapSize.set(1024, 1024);
    Object.assign(this.light.shadow.camera, { left: -scale, right: scale, top: scale, bottom: -scale, near: 0.1, far: 6 * scale });
    Object.assign(this.light.shadow, { radius: 4, bias: -0.0005, normalBias: 0.01 * scale });
    this.scene.add(this.light, this.light.target);
    const canvasTexture = new THREE.CanvasTexture(checker());
    canvasTexture.colorSpace = THREE.SRGBColorSpace;
    canvasTexture.wrapS = canvasTexture.wrapT = THREE.RepeatWrapping;
    canvasTexture.anisotropy = this.renderer.capabilities.getMaxAnisotropy();
    this.floor = new THREE.MeshStandardMaterial({ map: canvasTexture, roughness: 0.95, envMapIntensity: 0.6 });
    this.uneven = unevenGround(this.floor);
    this.arrow = new THREE.ArrowHelper(new THREE.Vector3(1, 0, 0), new THREE.Vector3(), 0.3 * scale, PUSH, 0.12 * scale, 0.09 * scale);
    this.arrow.visible = false;
    this.world.add(this.arrow);
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // A narrow screen sees as much to the sides as a square one.
    this.camera.fov = 38 * Math.min(1.5, Math.max(1, 1 / this.camera.aspect));
    const { top, right, bottom } = this.covered();
    /** Half of the length that is in sight at a distance of 1 m. */
    this.reach = (Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(width - right, height - top - bottom)) / height;
    this.camera.setViewOffset(width, height, right / 2, (bottom - top) / 2, width, height);
  }

  /** Look at the robot from the side and a little from the front, as in the project's films. */
  resetCamera(distance = 1) {
    this.camera.position.copy(this.target).add(new THREE.Vector3(0.75, -1.25, 0.6).multiplyScalar(distance * this.scale));
    this.zoom = 1;
  }

  /** Draw another ground. */
  setTerrain(terrain) {
    this.ground?.traverse((part) => part.geometry?.dispose());
    this.ground?.removeFromParent();
    this.ground = new THREE.Group();
    const side = 80 * this.scale, plane = new THREE.PlaneGeometry(side, side);
    tile(plane, this.scale);
    this.plane = new THREE.Mesh(plane, this.floor);
    this.plane.receiveShadow = true;
    this.ground.add(this.plane);
    if (terrain.grid) {
      const { shape: [rows, columns], extent, lowest, span } = terrain.grid;
      const field = new THREE.PlaneGeometry(...extent, columns - 1, rows - 1), points = field.attributes.position;
      for (let i = 0; i < points.count; i++) {
        // three.js counts rows from the far edge.
        const row = rows - 1 - Math.floor(i / columns);
        points.setZ(i, lowest + span * terrain.heights[row * columns + (i % columns)]);
      }
      tile(field, this.scale);
      shadeHollows(field);
      this.ground.add(Object.assign(new THREE.Mesh(field, this.uneven), { receiveShadow: true }));
      this.plane.position.z = lowest - 0.01 * this.scale;
    }
    this.world.add(this.ground);
  }

  /** Tilt the ground, so that it rises along x by an angle, rad. */
  setSlope(angle) {
    this.world.rotation.y = -angle;
  }

  /** Draw these simulations; a tint (colour and its share, 0 to 1) tells the second one from the first. */
  setRobots(simulations, tints) {
    for (const robot of this.robots) robot.group.removeFromParent();
    this.robots = simulations.map((simulation, i) => new DrawnRobot(simulation, tints[i], this.robot));
    for (const robot of this.robots) this.world.add(robot.group);
  }

  /** Remember the robots' poses after a control step, between which `draw` interpolates. */
  record() {
    for (const robot of this.robots) robot.record();
  }

  /** Draw a moment between the last two control steps, from 0 to 1. */
  draw(share, seconds) {
    this.saveTime(seconds);
    for (const robot of this.robots) robot.place(share);
    const [robot, other] = this.robots.map((drawn) => new THREE.Vector3(...drawn.position(share))), { x, y } = robot;
    const at = this.world.localToWorld(robot.clone());
    if (this.follow) this.followRobots(robot, other, seconds);
    this.orbit.target.copy(this.target);
    this.orbit.update();
    this.light.target.position.copy(at);
    this.light.position.copy(at).add(new THREE.Vector3(0.7, -0.7, 2.2).multiplyScalar(this.scale));
    const square = 2 * SQUARE * this.scale;
    this.plane.position.setX(square * Math.round(x / square)).setY(square * Math.round(y / square));
    if (this.arrow.visible && (this.arrow.left -= seconds) < 0) this.arrow.visible = false;
    this.renderer.render(this.scene, this.camera);
  }

  /** Move the camera along with one robot, or with the middle between two, from where both are in sight. */
  followRobots(robot, other, seconds) {
    const { scale, target, camera } = this, apart = other ? other.clone().sub(robot) : new THREE.Vector3();
    // The robot itself is followed at once, and the other one, which may jump, slowly.
    this.aside.lerp(apart.clone().multiplyScalar(0.5), Math.min(1, 3 * seconds));
    const moved = this.world.localToWorld(robot.clone().add(this.aside)).sub(target);
    // The height follows slowly, so that steps do not shake the picture.
    moved.z *= Math.min(1, 4 * seconds);
    target.add(moved);
    const away = camera.position.clone().add(moved).sub(target), chosen = away.length() / this.zoom;
    const needed = other ? (apart.length() / 2 + MARGIN * scale) / this.reach : 0;
    const zoom = this.zoom + (Math.max(1, needed / chosen) - this.zoom) * Math.min(1, 3 * seconds);
    camera.position.copy(target).addScaledVector(away, zoom / this.zoom);
    this.zoom = zoom;
  }

  /** Where there is no GPU, draw fewer pixels rather than fewer frames. */
  saveTime(seconds) {
    this.frameTime += (Math.min(seconds, 0.2) - this.frameTime) / 10;
    const ratio = this.renderer.getPixelRatio();
    if (++this.frames < 30 || this.frameTime < SLOW_FRAME || ratio < 0.5) return;
    this.frames = 0;
    this.renderer.setPixelRatio(0.7 * ratio);
  }

  /** Show a push of a robot in a direction of the world for a moment. */
  showPush(index, direction) {
    const { scale } = this, [x, y, z] = this.robots[index].position(1), away = new THREE.Vector3(...direction).normalize();
    this.arrow.position.set(x, y, z).addScaledVector(away, -0.5 * scale);
    this.arrow.setDirection(away);
    Object.assign(this.arrow, { visible: true, left: 0.5 });
  }

  /** The robot at a point of the canvas, and the horizontal direction in which a click pushes it; null if there is none. */
  pick(x, y) {
    const ray = new THREE.Raycaster(), { width, height } = this.canvas.getBoundingClientRect();
    ray.setFromCamera(new THREE.Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    const [hit] = ray.intersectObjects(this.robots.map((robot) => robot.group));
    if (!hit) return null;
    const index = this.robots.findIndex((robot) => robot.meshes.includes(hit.object));
    const away = ray.ray.direction.clone().applyQuaternion(this.world.quaternion.clone().invert()).setZ(0).normalize();
    return { index, direction: away.toArray() };
  }
}

/** A robot as three.js draws it: a group per body, with the geoms that MuJoCo's viewer shows. */
class DrawnRobot {
  constructor(simulation, tint, robot) {
    this.simulation = simulation;
    this.group = new THREE.Group();
    this.meshes = [];
    const { model } = simulation;
    this.bodies = Array.from({ length: model.nbody }, () => this.group.add(new THREE.Group()).children.at(-1));
    for (let i = 0; i < model.ngeom; i++) {
      const body = model.geom_bodyid[i], shape = body && model.geom_group[i] < HIDDEN_GROUP ? geometry(model, i) : null;
      if (!shape) continue;
      const mesh = new THREE.Mesh(shape, material(model, i, tint));
      mesh.position.fromArray(model.geom_pos, 3 * i);
      mesh.quaternion.copy(quaternion(model.geom_quat, i));
      mesh.castShadow = mesh.receiveShadow = true;
      this.bodies[body].add(mesh);
      this.meshes.push(mesh);
    }
    // Feet in the colours of the diagram of contacts.
    for (const { site, colour } of tint ? [] : robot.legs) {
      const id = simulation.mujoco.mj_name2id(model, simulation.mujoco.mjtObj.mjOBJ_SITE.value, site);
      const foot = new THREE.Mesh(new THREE.SphereGeometry(1.06 * robot.foot_radius, 32, 16), surface(new THREE.Color(colour)));
      foot.position.fromArray(model.site_pos, 3 * id);
      foot.castShadow = true;
      this.bodies[model.site_bodyid[id]].add(foot);
      this.meshes.push(foot);
    }
    this.record();
  }

  record() {
    const { xpos, xquat } = this.simulation.data;
    this.before = this.now ?? { xpos: xpos.slice(), xquat: xquat.slice() };
    this.now = { xpos: xpos.slice(), xquat: xquat.slice() };
  }

  place(share) {
    this.bodies.forEach((body, i) => {
      body.position.fromArray(this.before.xpos, 3 * i).lerp(new THREE.Vector3().fromArray(this.now.xpos, 3 * i), share);
      body.quaternion.copy(quaternion(this.before.xquat, i)).slerp(quaternion(this.now.xquat, i), share);
    });
  }

  /** Position of the base. */
  position(share) {
    const at = 3 * this.simulation.base;
    return [0, 1, 2].map((i) => (1 - share) * this.before.xpos[at + i] + share * this.now.xpos[at + i]);
  }
}

/** The i-th of MuJoCo's quaternions wxyz. */
const quaternion = (values, i) => new THREE.Quaternion(values[4 * i + 1], values[4 * i + 2], values[4 * i + 3], values[4 * i]);

function geometry(model, i) {
  const [a, b, c] = model.geom_size.slice(3 * i, 3 * i + 3);
  switch (model.geom_type[i]) {
    case SPHERE: return new THREE.SphereGeometry(a, 32, 16);
    case CAPSULE: return new THREE.CapsuleGeometry(a, 2 * b, 8, 24).rotateX(Math.PI / 2);
    case ELLIPSOID: return new THREE.SphereGeometry(1, 32, 16).scale(a, b, c);
    case CYLINDER: return new THREE.CylinderGeometry(a, a, 2 * b, 32).rotateX(Math.PI / 2);
    case BOX: return new RoundedBoxGeometry(2 * a, 2 * b, 2 * c, 4, 0.2 * Math.min(a, b, c));
    case MESH: return meshOf(model, model.geom_dataid[i]);
    default: return null;
  }
}

function meshOf(model, id) {
  const { mesh_vert: points, mesh_vertadr, mesh_vertnum, mesh_face: faces, mesh_faceadr, mesh_facenum } = model;
  const shape = new THREE.BufferGeometry(), start = mesh_vertadr[id], face = mesh_faceadr[id];
  shape.setAttribute('position', new THREE.BufferAttribute(points.slice(3 * start, 3 * (start + mesh_vertnum[id])), 3));
  shape.setIndex(Array.from(faces.slice(3 * face, 3 * (face + mesh_facenum[id]))));
  shape.computeVertexNormals();
  return shape;
}

function material(model, i, tint) {
  const id = model.geom_matid[i], [r, g, b] = id >= 0 ? model.mat_rgba.slice(4 * id, 4 * id + 3) : model.geom_rgba.slice(4 * i, 4 * i + 3);
  const color = new THREE.Color().setRGB(r, g, b, THREE.SRGBColorSpace);
  if (tint) color.lerp(new THREE.Color(tint.colour), tint.share);
  return surface(color);
}

const surface = (color) => new THREE.MeshStandardMaterial({ color, roughness: 0.5, metalness: 0.05 });

/**
 * Material of uneven ground: the steeper, the darker. Each triangle, which is MuJoCo's, has one normal; normals that are
 * shared between neighbours would round off every step.
 */
function unevenGround(floor) {
  const material = Object.assign(floor.clone(), { vertexColors: true, flatShading: true });
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_begin>', `#include <normal_fragment_begin>
      diffuseColor.rgb *= 1.0 - 0.5 * min(1.0, 16.0 * (1.0 - dot(normal, (viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz)));`);
  };
  return material;
}

/** Colour the hollows of a height field a little darker than its hills. */
function shadeHollows(field) {
  const { position } = field.attributes, colours = new Float32Array(3 * position.count);
  field.computeBoundingBox();
  const { min: { z: lowest }, max: { z: highest } } = field.boundingBox;
  for (let i = 0; i < position.count; i++) {
    const low = (highest - position.getZ(i)) / (highest - lowest), shade = 1 - 0.2 * low;
    colours.set([shade * (1 - 0.06 * low), shade * (1 - 0.02 * low), shade], 3 * i);
  }
  field.setAttribute('color', new THREE.BufferAttribute(colours, 3));
}

/** Texture coordinates, so that squares lie on the grid of the world. */
function tile(shape, scale) {
  const { position, uv } = shape.attributes, period = 2 * SQUARE * scale;
  for (let i = 0; i < position.count; i++) uv.setXY(i, position.getX(i) / period, position.getY(i) / period);
}

function checker() {
  const canvas = document.createElement('canvas'), size = 256, half = size / 2;
  canvas.width = canvas.height = size;
  const pen = canvas.getContext('2d');
  for (const [i, colour] of FLOOR.entries()) {
    pen.fillStyle = colour;
    pen.fillRect(0, i * half, half, half);
    pen.fillRect(half, (1 - i) * half, half, half);
  }
  return canvas;
}
