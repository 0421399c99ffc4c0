// Constraints of a scene as objects of three.js, in mm, in W.
import * as THREE from "three";

const LONG = 320; // mm at a haptic arm: what is infinite is drawn so long
const Z = new THREE.Vector3(0, 0, 1);
const Y = new THREE.Vector3(0, 1, 0);

function placed(object, position, from, to) {
  object.position.set(...position);
  if (to) object.quaternion.setFromUnitVectors(from, new THREE.Vector3(...to).normalize());
  return object;
}

/** R_WB: rows, may be missing. */
function turned(object, R_WB) {
  if (R_WB) {
    const [a, b, c] = R_WB;
    object.setRotationFromMatrix(new THREE.Matrix4().set(...a, 0, ...b, 0, ...c, 0, 0, 0, 0, 1));
  }
  return object;
}

/** A ball with half axes of its own. */
function ball(materials, semi) {
  const group = new THREE.Group();
  const edges = new THREE.EdgesGeometry(new THREE.SphereGeometry(1, 16, 8), 1);
  group.add(new THREE.Mesh(new THREE.SphereGeometry(1, 48, 32), materials.fill), new THREE.LineSegments(edges, materials.edge));
  group.scale.set(...semi);
  return group;
}

/** Makers by the type of a constraint: (constraint, materials, size) to an object. size: as View.size. */
const MAKERS = {
  point: (c, m, size) => placed(new THREE.Mesh(new THREE.SphereGeometry(3 * size, 24, 16), m.solid), c.position_mm),
  sphere: (c, m) => placed(ball(m, [c.radius_mm, c.radius_mm, c.radius_mm]), c.center_mm),
  ellipsoid: (c, m) => turned(placed(ball(m, c.semi_axes_mm), c.center_mm), c.R_WB),
  line: (c, m, size) => placed(new THREE.Mesh(new THREE.CylinderGeometry(0.8 * size, 0.8 * size, LONG * size), m.solid), c.point_mm, Y, c.direction),
  plane: (c, m, size) => {
    const group = new THREE.Group();
    const shape = new THREE.PlaneGeometry(LONG * size, LONG * size);
    group.add(new THREE.Mesh(shape, m.fill), new THREE.LineSegments(new THREE.EdgesGeometry(shape), m.edge));
    return placed(group, c.point_mm, Z, c.normal);
  },
  circle: (c, m, size) => placed(new THREE.Mesh(new THREE.TorusGeometry(c.radius_mm, 0.8 * size, 8, 96), m.solid), c.center_mm, Z, c.normal),
  cylinder: (c, m, size) => {
    const shape = new THREE.CylinderGeometry(c.radius_mm, c.radius_mm, LONG * size, 48, 1, true);
    return placed(new THREE.Mesh(shape, m.fill), c.point_mm, Y, c.axis);
  },
  box: (c, m) => {
    const group = new THREE.Group();
    const shape = new THREE.BoxGeometry(...c.size_mm);
    group.add(new THREE.Mesh(shape, m.fill), new THREE.LineSegments(new THREE.EdgesGeometry(shape), m.edge));
    return turned(placed(group, c.center_mm), c.R_WB);
  },
};

/** The objects of a scene, and the names of the constraints that this page does not draw. */
export function drawn(scene, materials, size) {
  const objects = [];
  const left = [];
  for (const constraint of scene.constraints) {
    const make = MAKERS[constraint.type];
    if (make) objects.push(make(constraint, materials, size));
    else left.push(`${constraint.name} (${constraint.type.replace("_", " ")})`);
  }
  return { objects, left };
}
