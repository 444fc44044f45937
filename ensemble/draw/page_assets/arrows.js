'use strict';
// Many arrows in one draw call. The stage draws them over everything else: forces act where bodies hide each other.

const arrowVertexShader = `
attribute vec3 start, along, paint;
attribute float thick;
varying vec3 vPaint;
varying float vLight;
void main() {
  float len = max(length(along), 1e-9);
  vec3 axis = along / len;
  vec3 side = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
  vec3 other = cross(axis, side);
  float head = min(6.0 * thick, 0.5 * len);
  float width = min(thick, head / 6.0);
  // position: direction round the axis, and 0 at the tail, 1 at the neck, 2 at the tip; normal.x: radius in widths.
  float at = position.z < 0.5 ? 0.0 : position.z < 1.5 ? len - head : len;
  vec3 round = position.x * side + position.y * other;
  vec3 place = start + at * axis + normal.x * width * round;
  vLight = 0.84 + 0.16 * dot(normalize(round + vec3(1e-6)), normalize(vec3(-0.4, 0.8, 0.5)));
  vPaint = paint;
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}`;

const arrowFragmentShader = `
varying vec3 vPaint;
varying float vLight;
void main() { gl_FragColor = vec4(vPaint * vLight, 1.0); }`;

// A shaft and a head of so many sides.
function arrowGeometry(sides) {
  const rings = [[0, 0], [0, 1], [1, 1], [1, 2.4], [2, 0]]; // where along the arrow, radius
  const position = [];
  const radius = [];
  const index = [];
  for (const [along, r] of rings)
    for (let i = 0; i < sides; ++i) {
      const angle = 2 * Math.PI * i / sides;
      position.push(Math.cos(angle), Math.sin(angle), along);
      radius.push(r, 0, 0);
    }
  for (let ring = 0; ring + 1 < rings.length; ++ring)
    for (let i = 0; i < sides; ++i) {
      const a = ring * sides + i;
      const b = ring * sides + (i + 1) % sides;
      index.push(a, b, a + sides, b, b + sides, a + sides);
    }
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex(index);
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(position, 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(radius, 3));
  return geometry;
}

class Arrows {
  constructor(most) {
    this.geometry = arrowGeometry(12);
    this.most = most;
    for (const [name, each] of [['start', 3], ['along', 3], ['paint', 3], ['thick', 1]])
      this.geometry.setAttribute(name,
        new THREE.InstancedBufferAttribute(new Float32Array(each * most), each).setUsage(THREE.DynamicDrawUsage));
    const material = new THREE.ShaderMaterial({
      vertexShader: arrowVertexShader, fragmentShader: arrowFragmentShader,
    });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  // Each {start, along, thick} in metres, and colour.
  show(list) {
    const {start, along, paint, thick} = this.geometry.attributes;
    list.slice(0, this.most).forEach((arrow, i) => {
      start.array.set(arrow.start, 3 * i);
      along.array.set(arrow.along, 3 * i);
      paint.array.set(arrow.colour, 3 * i);
      thick.array[i] = arrow.thick;
    });
    for (const attribute of [start, along, paint, thick]) attribute.needsUpdate = true;
    this.geometry.maxInstancedCount = Math.min(list.length, this.most);
    this.mesh.visible = list.length > 0;
  }
}

// Where the tow goes, ahead of the structure.
function towArrow(replay, time) {
  const {structure: {radius, top}, tow} = replay.header;
  const ahead = Math.sign(tow.speed) || 1;
  const {x, z} = replay.structureAt(time);
  const {x: later, z: aside} = replay.structureAt(time + 1); // where the way leads
  const way = Math.hypot(later - x, aside - z);
  const [cx, cz] = replay.header.poses && way > 0 ? [(later - x) / way, (aside - z) / way] : [ahead, 0];
  return {start: [x + 1.08 * cx * radius, top, z + 1.08 * cz * radius], along: [0.75 * cx * radius, 0, 0.75 * cz * radius],
    colour: new THREE.Color(styled('tow')).toArray(), thick: 0.03 * radius};
}

// The mooring lines that hold at a frame, as far as they are to be seen.
function lineArrows(replay, frame) {
  const {structure: {radius}, lines, poses, step} = replay.header;
  if (!lines || !poses) return [];
  // Of all frames of the recording, some of which the page may have left out.
  const recorded = poses.findIndex(([time]) => time > replay.times[frame] - 0.5 * step);
  return (lines[recorded] || []).map(([x, y, z, ...along]) => ({start: [x, y + 0.02 * radius, z], along,
    colour: new THREE.Color(styled('ink')).toArray(), thick: 0.015 * radius}));
}

// The arrows of the paper's Fig. 5 at a frame. `metres` is the length of 1 N.
function forceArrows(replay, frame, time, metres, {load, contacts, ice}) {
  const {radius, top} = replay.header.structure;
  const colour = name => new THREE.Color(styled(name)).toArray();
  const arrows = [];
  const add = (start, force, name, thick) => {
    const along = force.map(part => part * metres);
    if (Math.hypot(...along) > 0.02 * radius) arrows.push({start, along, colour: colour(name), thick});
  };
  if (contacts || ice)
    for (const [point, normal, friction, isOfStructure] of replay.contactsAt(frame)) {
      if (!(isOfStructure ? contacts : ice)) continue;
      add(point, friction, 'friction', 0.012 * radius);
      add(point, normal, 'normal', 0.012 * radius);
    }
  if (load) {
    const {x: axisX, z: axisZ} = replay.structureAt(time);
    const axis = [axisX, top, axisZ];
    const {force, axes, surge, sway, heave} = replay.loadAt(frame);
    const along = (direction, size) => direction.map(part => size * part);
    add(axis, force, 'ink', 0.035 * radius);
    add(axis, along(axes[0], -surge), 'surge', 0.025 * radius);
    add(axis, along(axes[2], sway), 'sway', 0.025 * radius);
    add(axis, along(axes[1], heave), 'heave', 0.025 * radius);
  }
  return arrows;
}
