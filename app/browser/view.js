// The view: the workspace, the arm, its constraints, the target and the force, in mm, in W (y is up).
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { CUT_N } from "./history.js";
import { isUpright, linkOrigins, reachOf } from "./kinematics.js";
import { drawn } from "./shapes.js";

const FORCE_MM_PER_N = 80;
const HEAD_MM = 9;
const HAPTIC_MM = 300; // the reach of a haptic arm, for which the sizes here are
const TURN_RAD = Math.PI / 36;
const UP = new THREE.Vector3(0, 1, 0);
const SLOW_MS = 25; // between pictures, on average of LOOKED_AT: fewer pixels then, down to FEWEST of a side
const LOOKED_AT = 30;
const FEWEST = 0.5;

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** WebGL without a graphics card: smooth edges would take three times as long there. */
function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  return /swiftshader|llvmpipe|software/i.test(names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "");
}

function sphere(radius, material) {
  return new THREE.Mesh(new THREE.SphereGeometry(radius, 16, 12), material);
}

export class View {
  /** canvas: that it draws in. arms: files of arms by their names. Fails where there is no WebGL. */
  constructor(canvas, arms) {
    Object.assign(this, { canvas, arms, share: 1, pictures: 0, since_ms: 0 });
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !isSoftware() });
    this.camera = new THREE.PerspectiveCamera(35, 1, 1, 20000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.minDistance = 100;
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    this.scene = new THREE.Scene();
    const light = new THREE.DirectionalLight(0xffffff, 2);
    light.position.set(1, 2, 2);
    this.scene.add(new THREE.AmbientLight(0xffffff, 1.4), light);
    this.make();
    this.stand(null);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paint());
    this.paint();
  }

  make() {
    const standard = () => new THREE.MeshLambertMaterial();
    this.materials = {
      solid: new THREE.MeshLambertMaterial(),
      fill: new THREE.MeshLambertMaterial({ transparent: true, opacity: 0.25, side: THREE.DoubleSide, depthWrite: false }),
      edge: new THREE.LineBasicMaterial({ transparent: true, opacity: 0.6 }),
    };
    this.arm = standard();
    this.target = new THREE.MeshBasicMaterial({ depthTest: false }); // seen within a shape, too
    this.push = new THREE.MeshBasicMaterial();
    this.box = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry(160, 120, 70)), new THREE.LineBasicMaterial());
    this.world = new THREE.Group(); // W in the frame of the camera, whose y is up
    this.links = new THREE.Group();
    this.joints = [];
    this.rods = [];
    this.nearest = new THREE.Mesh(new THREE.BoxGeometry(5, 5, 5), this.target);
    this.force = new THREE.Group();
    this.shaft = new THREE.Mesh(new THREE.CylinderGeometry(1.2, 1.2, 1, 12).translate(0, 0.5, 0), this.push);
    this.head = new THREE.Mesh(new THREE.ConeGeometry(3.5, HEAD_MM, 16).translate(0, 0.5 * HEAD_MM, 0), this.push);
    this.force.add(this.shaft, this.head);
    this.constraints = new THREE.Group();
    this.nearest.visible = this.force.visible = false;
    this.world.add(this.box, this.links, this.nearest, this.force, this.constraints);
    this.scene.add(this.world);
  }

  paint() {
    this.renderer.setClearColor(colour("ground"));
    for (const material of [this.materials.solid, this.materials.fill, this.materials.edge]) material.color.set(colour("constraint"));
    this.box.material.color.set(colour("line"));
    this.arm.color.set(colour("arm"));
    this.target.color.set(colour("target"));
    this.colours = { force: new THREE.Color(colour("force")), cut: new THREE.Color(colour("cut")) };
  }

  /** Shows the constraints of a scene; gives the names of those that it cannot draw. */
  show(scene, arm_name) {
    this.stand(arm_name);
    for (const old of [...this.constraints.children]) {
      this.constraints.remove(old);
      old.traverse((part) => part.geometry?.dispose());
    }
    const { objects, left } = drawn(scene, this.materials, this.size);
    if (objects.length > 0) this.constraints.add(...objects);
    return left;
  }

  /** A tick: { q_rad, p_WT_mm, p_WP_mm, force_sent_N, cut_N }. */
  place(tick) {
    const is_known = this.table !== undefined && this.table.dh.length <= tick.q_rad.length;
    const origins = is_known ? linkOrigins(this.table, tick.q_rad) : [[0, 0, -200], tick.p_WT_mm];
    if (this.must_frame && is_known) this.frame(origins);
    this.bend(origins.map((origin) => new THREE.Vector3(...origin)));
    this.nearest.visible = tick.p_WP_mm.length === 3;
    if (this.nearest.visible) this.nearest.position.set(...tick.p_WP_mm);
    const force = new THREE.Vector3(...tick.force_sent_N);
    const force_N = force.length();
    this.force.visible = force_N > 1e-3;
    if (!this.force.visible) return;
    this.force.position.set(...tick.p_WT_mm);
    this.force.quaternion.setFromUnitVectors(UP, force.divideScalar(force_N));
    this.shaft.scale.y = this.head.position.y = (FORCE_MM_PER_N * force_N) / this.size; // in the group's own measure
    this.push.color.copy(tick.cut_N > CUT_N ? this.colours.cut : this.colours.force);
  }

  /** Another arm. A haptic arm stands behind its workspace, whose middle is looked at; of another one all is seen. */
  stand(arm_name) {
    if (this.arm_name === arm_name) return;
    this.arm_name = arm_name;
    this.table = this.arms[arm_name];
    this.is_robot = this.table !== undefined && isUpright(this.table);
    this.size = this.is_robot ? Math.max(1, reachOf(this.table) / HAPTIC_MM) : 1;
    this.world.rotation.x = this.is_robot ? -0.5 * Math.PI : 0; // its z is up, and the camera's y
    this.world.updateMatrixWorld();
    this.box.visible = !this.is_robot;
    for (const one of [this.nearest, this.force]) one.scale.setScalar(this.size);
    this.frame([[0, 0, 0]]);
    this.must_frame = this.is_robot; // where it is, the next tick says
  }

  /** Turns the camera to the middle of points, mm, in W. */
  frame(points) {
    this.must_frame = false;
    const middle = new THREE.Box3().setFromPoints(points.map((point) => new THREE.Vector3(...point))).getCenter(new THREE.Vector3());
    this.world.localToWorld(middle);
    this.controls.target.copy(middle);
    this.camera.position.set(170, 150, 470).multiplyScalar(this.size).add(middle);
    this.controls.maxDistance = 2000 * this.size;
    this.controls.update();
  }

  /** Balls at the joints and rods between them; the last one is the tip. */
  bend(origins) {
    while (this.joints.length < origins.length) {
      this.joints.push(sphere(1, this.arm));
      this.rods.push(new THREE.Mesh(new THREE.CylinderGeometry(3, 3, 1, 12, 1, true), this.arm));
      this.links.add(this.joints.at(-1), this.rods.at(-1));
    }
    this.joints.forEach((ball, index) => {
      const rod = this.rods[index];
      ball.visible = index < origins.length;
      rod.visible = index + 1 < origins.length && origins[index].distanceTo(origins[index + 1]) > 1e-3;
      if (ball.visible) ball.position.copy(origins[index]);
      ball.scale.setScalar(this.size * (index + 1 === origins.length ? 4 : 6));
      if (!rod.visible) return;
      const along = origins[index + 1].clone().sub(origins[index]);
      rod.scale.set(this.size, along.length(), this.size);
      rod.position.copy(origins[index]).addScaledVector(along, 0.5);
      rod.quaternion.setFromUnitVectors(UP, along.normalize());
    });
  }

  /** Where the joints of the arm that are drawn are in the picture, base first: x and y from -1 to 1. */
  seen() {
    const drawn = this.joints.filter(({ visible }) => visible);
    return drawn.map((ball) => ball.getWorldPosition(new THREE.Vector3()).project(this.camera).toArray().slice(0, 2));
  }

  key(event) {
    const about = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    if (event.key === "ArrowLeft") about.theta -= TURN_RAD;
    else if (event.key === "ArrowRight") about.theta += TURN_RAD;
    else if (event.key === "ArrowUp") about.phi -= TURN_RAD;
    else if (event.key === "ArrowDown") about.phi += TURN_RAD;
    else if (event.key === "+") about.radius /= 1.1;
    else if (event.key === "-") about.radius *= 1.1;
    else return;
    event.preventDefault();
    about.makeSafe();
    about.radius = Math.min(Math.max(about.radius, this.controls.minDistance), this.controls.maxDistance);
    this.camera.position.setFromSpherical(about).add(this.controls.target);
    this.controls.update();
  }

  /** A slow computer draws fewer pixels, not fewer pictures. */
  adapt(now_ms) {
    if (++this.pictures < LOOKED_AT) return;
    const between_ms = (now_ms - this.since_ms) / this.pictures;
    this.share = between_ms > SLOW_MS ? Math.max(0.8 * this.share, FEWEST) : Math.min(1.05 * this.share, 1);
    this.pictures = 0;
    this.since_ms = now_ms;
  }

  draw(now_ms) {
    this.adapt(now_ms);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ratio = this.share * Math.min(devicePixelRatio, 2);
    if (this.width !== width || this.height !== height || this.ratio !== ratio) {
      Object.assign(this, { width, height, ratio });
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
    }
    this.renderer.render(this.scene, this.camera);
  }
}
