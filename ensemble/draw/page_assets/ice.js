'use strict';
// All elements in one draw call: boxes that stand between their places in two neighbouring frames.

// What boxes here and polygons of polygons.js share: where an element is, the lines on its faces, and light.
const placedElement = `
attribute vec3 placeA, placeB, tint;
attribute vec4 turnA, turnB;
uniform float share, quantum;
uniform vec3 middle;
varying vec3 vTint, vNormal, vUp, vSide, vWorld;
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
void place(vec3 corner, vec3 side) {
  vec4 turn = normalize(mix(turnA, turnB, share));
  vWorld = middle + quantum * mix(placeA, placeB, share) + turned(turn, corner);
  vTint = tint;
  vNormal = turned(turn, side);
  vUp = turned(turn, vec3(0.0, 1.0, 0.0));
  vSide = side;
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
  if (dot(turnA, turnA) < 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // not there: all corners in one place
}`;

// Lines along the edges of upper and lower faces tell joints (faint), outlines of floes (dark), outlines of broken
// floes and failed joints apart; faces that a failed joint left have its colour.
const drawnElement = `
uniform float parallel;
uniform vec3 sun, sight, water, jointLine, rimLine, brokenLine, failedLine;
varying vec3 vTint, vNormal, vUp, vSide, vWorld;
void line(inout vec3 colour, float edge, float distance, float pixel) {
  float failed = step(0.9, edge), broken = step(0.6, edge) - failed, rim = step(0.3, edge) - failed - broken;
  vec3 ink = failed * failedLine + broken * brokenLine + rim * rimLine +
             (1.0 - failed - broken - rim) * jointLine;
  float strength = 0.3 + 0.4 * rim + 0.6 * broken + 0.7 * failed;
  float width = max(0.012 + 0.008 * rim + 0.02 * broken + 0.035 * failed,
                    pixel * (0.5 + 0.3 * rim + 0.8 * broken + 1.5 * failed));
  float fade = failed + broken + rim + (1.0 - failed - broken - rim) * clamp(0.25 / (pixel * 6.0), 0.0, 1.0);
  colour = mix(colour, ink, strength * fade * (1.0 - smoothstep(width - pixel, width + pixel, distance)));
}
// The colour of a face in light; edge is that of a side, and does not matter for a flat face.
vec4 lit(vec3 colour, bool flatFace, float edge) {
  vec3 n = normalize(vNormal);
  vec3 view = parallel > 0.5 ? -sight : normalize(cameraPosition - vWorld);
  if (!flatFace) {
    colour = mix(colour, failedLine, 0.5 * step(0.9, edge));
    // Within a piece, faces show only through gaps thinner than a pixel: there they must look like what is round them.
    if (edge < 0.3) n = vUp * sign(dot(vUp, view));
  }
  float light = 0.68 + 0.08 * n.y + 0.2 * max(dot(n, sun), 0.0) + 0.2 * max(dot(n, view), 0.0);
  colour *= min(light, 1.04);
  return vec4(mix(colour, water, vWorld.y < 0.0 ? 0.15 : 0.0), 1.0);
}`;

const iceVertexShader = placedElement + `
attribute vec3 size;
attribute vec4 edges;
varying vec3 vLocal;
varying vec4 vEdges;
void main() {
  place(size * position, normal);
  vLocal = position;
  vEdges = edges;
}`;

const iceFragmentShader = drawnElement + `
varying vec3 vLocal;
varying vec4 vEdges;
void main() {
  vec3 colour = vTint;
  bool flatFace = abs(vSide.y) > 0.5;
  if (flatFace) {
    vec2 pixel = fwidth(vLocal.xz);
    line(colour, vEdges.x, 0.5 - vLocal.x, pixel.x);
    line(colour, vEdges.z, 0.5 + vLocal.x, pixel.x);
    line(colour, vEdges.y, 0.5 - vLocal.z, pixel.y);
    line(colour, vEdges.w, 0.5 + vLocal.z, pixel.y);
  }
  float edge = vSide.x > 0.5 ? vEdges.x : vSide.z > 0.5 ? vEdges.y : vSide.x < -0.5 ? vEdges.z : vEdges.w;
  gl_FragColor = lit(colour, flatFace, edge);
}`;

const sunDirection = new THREE.Vector3(-0.45, 0.8, 0.5).normalize();

// How strong the line of an edge is where no joint has failed: of an outline, of that of a broken floe, or of neither.
function lineOf({outlines, floeOf}, element, edge, brokenFloes) {
  return !(outlines[element] >> edge & 1) ? 0 : brokenFloes.has(floeOf[element]) ? 191 : 128;
}

class Ice {
  constructor(replay) {
    this.replay = replay;
    const {header, elements} = replay;
    const box = new THREE.BoxBufferGeometry(1, 1, 1);
    this.geometry = new THREE.InstancedBufferGeometry();
    this.geometry.setIndex(box.index);
    this.geometry.setAttribute('position', box.attributes.position);
    this.geometry.setAttribute('normal', box.attributes.normal);
    this.geometry.maxInstancedCount = elements;
    const add = (name, array, each, normalised) => this.geometry.setAttribute(name,
      new THREE.InstancedBufferAttribute(array, each, normalised).setUsage(THREE.DynamicDrawUsage));
    for (const frame of ['A', 'B']) {
      add('place' + frame, new Int16Array(3 * elements), 3, false);
      add('turn' + frame, new Int16Array(4 * elements), 4, false);
    }
    add('size', replay.sizes, 3, false);
    add('tint', new Uint8Array(3 * elements), 3, true);
    add('edges', new Uint8Array(4 * elements), 4, true);
    const three = list => new THREE.Vector3(...list);
    const colour = () => ({value: new THREE.Color()});
    this.material = new THREE.ShaderMaterial({
      vertexShader: iceVertexShader, fragmentShader: iceFragmentShader, extensions: {derivatives: true},
      uniforms: {
        share: {value: 0}, quantum: {value: header.quanta.length}, middle: {value: three(header.quanta.middle)},
        sun: {value: sunDirection},
        parallel: {value: 0}, sight: {value: new THREE.Vector3()},
        water: colour(), jointLine: colour(), rimLine: colour(), brokenLine: colour(), failedLine: colour(),
      },
    });
    const boxes = new THREE.Mesh(this.geometry, this.material);
    boxes.frustumCulled = false; // its vertices are placed by the graphics card
    this.mesh = new THREE.Group().add(boxes);
    this.polygons = replay.corners.some(one => one) ? new PolygonIce(replay, this.material.uniforms) : null;
    if (this.polygons) this.mesh.add(this.polygons.mesh);
    this.shown = {A: -1, B: -1};
    this.failures = -1;
  }

  useTheme() {
    const names = {water: 'water', jointLine: 'joint', rimLine: 'rim', brokenLine: 'broken', failedLine: 'failed'};
    for (const [uniform, name] of Object.entries(names)) this.material.uniforms[uniform].value.set(styled(name));
  }

  lookFrom(camera) {
    const {parallel, sight} = this.material.uniforms;
    parallel.value = camera.isOrthographicCamera ? 1 : 0;
    camera.getWorldDirection(sight.value);
  }

  refill(name, values) {
    const attribute = this.geometry.attributes[name];
    attribute.array.set(values);
    attribute.needsUpdate = true;
    if (this.polygons) this.polygons.refill(name, values);
  }

  put(slot, frame) {
    if (this.shown[slot] === frame) return;
    this.shown[slot] = frame;
    const {places, turns, elements} = this.replay;
    this.refill('place' + slot, places.subarray(3 * frame * elements, 3 * (frame + 1) * elements));
    this.refill('turn' + slot, turns.subarray(4 * frame * elements, 4 * (frame + 1) * elements));
  }

  // Between the frames on both sides of a time.
  moveTo(time) {
    const {times, frames} = this.replay;
    const frame = this.replay.frameAt(time);
    const next = Math.min(frame + 1, frames - 1);
    this.put('A', frame);
    this.put('B', next);
    this.material.uniforms.share.value =
      next > frame ? Math.min(Math.max((time - times[frame]) / (times[next] - times[frame]), 0), 1) : 0;
  }

  // Marks joints that have failed: failures as in the header.
  markFailures(failures, brokenFloes) {
    if (this.failures === failures.length) return;
    this.failures = failures.length;
    const {elements, corners} = this.replay;
    const edges = this.geometry.attributes.edges.array;
    for (let e = 0; e < elements; ++e)
      for (let k = 0; k < 4; ++k) edges[4 * e + k] = lineOf(this.replay, e, k, brokenFloes);
    for (const [, , , a, edgeOfA, b, edgeOfB] of failures) {
      if (!corners[a]) edges[4 * a + Math.log2(edgeOfA)] = 255;
      if (!corners[b]) edges[4 * b + Math.log2(edgeOfB)] = 255;
    }
    if (this.polygons) this.polygons.markFailures(failures, brokenFloes);
    this.geometry.attributes.edges.needsUpdate = true;
  }
}
