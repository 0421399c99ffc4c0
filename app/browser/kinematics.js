// Where the links of an arm are, from its file (resources/arms).

/** Row-major 4 x 4. */
function product(a, b) {
  const c = new Array(16).fill(0);
  for (let i = 0; i < 4; ++i)
    for (let j = 0; j < 4; ++j) for (let k = 0; k < 4; ++k) c[4 * i + j] += a[4 * i + k] * b[4 * k + j];
  return c;
}

const turn = (angle, axis) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return axis === "x" ? [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1] : [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
};
const shift = (x, z) => [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, z, 0, 0, 0, 1];
const rad = (degrees = 0) => (degrees * Math.PI) / 180;

/** A row of the table: about and along x before the joint's own z (modified), or after it (classic). */
function link(row, q, is_classic) {
  const slides = row.type === "prismatic";
  const about_x = [turn(rad(row.alpha_deg), "x"), shift(row.a_mm ?? 0, 0)];
  const about_z = [turn(rad(row.theta_deg) + (slides ? 0 : q), "z"), shift(0, (row.d_mm ?? 0) + (slides ? 1000 * q : 0))];
  return (is_classic ? [...about_z, ...about_x] : [...about_x, ...about_z]).reduce(product);
}

/** The origins of the frames of an arm file, mm, in W, base first: a list of [x, y, z]. q: rad, m where a joint slides. */
export function linkOrigins(arm, q) {
  let X = arm.X_WB.flat();
  const origins = [[X[3], X[7], X[11]]];
  arm.dh.forEach((row, index) => {
    X = product(X, link(row, q[index], arm.convention === "classic"));
    origins.push([X[3], X[7], X[11]]);
  });
  const X_NT = arm.X_6T ?? arm.X_NT;
  if (X_NT) {
    X = product(X, X_NT.flat());
    origins.push([X[3], X[7], X[11]]);
  }
  return origins;
}

/** Whether z is up in W, as for robots; in the workspace of a haptic arm, y is. */
export function isUpright(arm) {
  return arm.X_WB[2][2] > 0.9;
}

/** How far its tip is from its base along the links, mm, with slides at 0. */
export function reachOf(arm) {
  const origins = linkOrigins(arm, new Array(arm.dh.length).fill(0));
  return origins.slice(1).reduce((sum, one, index) => sum + Math.hypot(...one.map((x, axis) => x - origins[index][axis])), 0);
}

/** The joints of an arm in words, first to last: degrees, mm where one slides. q as for linkOrigins(). */
export function jointTexts(arm, q) {
  return arm.dh.map((row, index) =>
    row.type === "prismatic" ? `${(1000 * q[index]).toFixed(1)} mm` : `${((180 * q[index]) / Math.PI).toFixed(1)}°`,
  );
}
