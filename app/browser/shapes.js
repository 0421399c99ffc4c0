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

/** Makers by the type of a constraint: (constraint, materials, size) to an object. size: as View.size. */
const MAKERS = {
  point: (c, m, size) => placed(new THREE.Mesh(new THREE.SphereGeometry(3 * size, 24, 16), m.solid), c.position_mm),
  sphere: (c, m) => {
    const group = new THREE.Group();
    const shape = new THREE.SphereGeometry(c.radius_mm, 48, 32);
    group.add(new THREE.Mesh(shape, m.fill));
    group.add(new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.SphereGeometry(c.radius_mm, 16, 8), 1), m.edge));
    return placed(group, c.center_mm);
  },
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
    placed(group, c.center_mm);
    if (c.R_WB) {
      const [a, b, d] = c.R_WB;
      group.setRotationFromMatrix(new THREE.Matrix4().set(...a, 0, ...b, 0, ...d, 0, 0, 0, 0, 1));
    }
    return group;
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
