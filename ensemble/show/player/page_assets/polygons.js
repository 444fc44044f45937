'use strict';
// Elements that are convex polygons: flat faces of triangles round the middle, each at one edge, and a side at each.

const polygonVertexShader = `
attribute vec3 placeA, placeB, tint, side;
attribute vec4 turnA, turnB;
attribute float edge, inwards;
uniform float share, quantum;
uniform vec3 middle;
varying vec3 vTint, vNormal, vUp, vSide, vWorld;
varying float vEdge, vInwards;
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
void main() {
  vec4 turn = normalize(mix(turnA, turnB, share));
  vWorld = middle + quantum * mix(placeA, placeB, share) + turned(turn, position);
  vTint = tint;
  vNormal = turned(turn, side);
  vUp = turned(turn, vec3(0.0, 1.0, 0.0));
  vSide = side;
  vEdge = edge;
  vInwards = inwards;
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`;

// As of boxes; the distance to the edge is in shares of the element's size.
const polygonFragmentShader = `
uniform float parallel;
uniform vec3 sun, sight, water, jointLine, rimLine, brokenLine, failedLine;
varying vec3 vTint, vNormal, vUp, vSide, vWorld;
varying float vEdge, vInwards;
void main() {
  vec3 colour = vTint;
  vec3 n = normalize(vNormal);
  vec3 view = parallel > 0.5 ? -sight : normalize(cameraPosition - vWorld);
  float failed = step(0.9, vEdge), broken = step(0.6, vEdge) - failed, rim = step(0.3, vEdge) - failed - broken;
  float joint = 1.0 - failed - broken - rim;
  if (abs(vSide.y) > 0.5) {
    float pixel = fwidth(vInwards);
    vec3 ink = failed * failedLine + broken * brokenLine + rim * rimLine + joint * jointLine;
    float strength = 0.3 + 0.4 * rim + 0.6 * broken + 0.7 * failed;
    float width = max(0.012 + 0.008 * rim + 0.02 * broken + 0.035 * failed,
                      pixel * (0.5 + 0.3 * rim + 0.8 * broken + 1.5 * failed));
    float fade = failed + broken + rim + joint * clamp(0.25 / (pixel * 6.0), 0.0, 1.0);
    colour = mix(colour, ink, strength * fade * (1.0 - smoothstep(width - pixel, width + pixel, vInwards)));
  } else {
    colour = mix(colour, failedLine, 0.5 * failed);
    if (vEdge < 0.3) n = vUp * sign(dot(vUp, view));
  }
  float light = 0.68 + 0.08 * n.y + 0.2 * max(dot(n, sun), 0.0) + 0.2 * max(dot(n, view), 0.0);
  colour *= min(light, 1.04);
  gl_FragColor = vec4(mix(colour, water, vWorld.y < 0.0 ? 0.15 : 0.0), 1.0);
}`;

class PolygonIce {
  constructor(replay, uniforms) {
    this.replay = replay;
    this.elementOf = []; // of each vertex
    this.edgeOf = [];
    const position = [], side = [], inwards = [];
    const triangle = (element, edge, normal, corners) => {
      for (const [x, y, z, far] of corners) {
        position.push(x, y, z);
        side.push(...normal);
        inwards.push(far);
        this.elementOf.push(element);
        this.edgeOf.push(edge);
      }
    };
    replay.corners.forEach((corners, element) => {
      if (!corners) return;
      const half = replay.sizes[3 * element + 1] / 2;
      const size = Math.max(...corners.map(([x, z]) => Math.hypot(x, z)));
      corners.forEach(([x, z], edge) => {
        const [u, w] = corners[(edge + 1) % corners.length];
        const length = Math.hypot(u - x, w - z);
        const out = [(w - z) / length, 0, (x - u) / length];
        const far = (out[0] * x + out[2] * z) / size;
        triangle(element, edge, [0, 1, 0], [[0, half, 0, far], [u, half, w, 0], [x, half, z, 0]]);
        triangle(element, edge, [0, -1, 0], [[0, -half, 0, far], [x, -half, z, 0], [u, -half, w, 0]]);
        triangle(element, edge, out, [[x, -half, z, 0], [x, half, z, 0], [u, half, w, 0]]);
        triangle(element, edge, out, [[x, -half, z, 0], [u, half, w, 0], [u, -half, w, 0]]);
      });
    });
    const count = this.elementOf.length;
    this.geometry = new THREE.BufferGeometry();
    const add = (name, array, each, normalised) => {
      const attribute = new THREE.BufferAttribute(array, each, normalised);
      attribute.setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
    };
    add('position', new Float32Array(position), 3, false);
    add('side', new Float32Array(side), 3, false);
    add('inwards', new Float32Array(inwards), 1, false);
    add('edge', new Uint8Array(count), 1, true);
    add('tint', new Uint8Array(3 * count), 3, true);
    for (const frame of ['A', 'B']) {
      add('place' + frame, new Int16Array(3 * count), 3, false);
      add('turn' + frame, new Int16Array(4 * count), 4, false);
    }
    const material = new THREE.ShaderMaterial({
      vertexShader: polygonVertexShader, fragmentShader: polygonFragmentShader, extensions: {derivatives: true},
      uniforms, side: THREE.DoubleSide,
    });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  // Values of all elements, some numbers each.
  refill(name, values) {
    const attribute = this.geometry.attributes[name];
    const each = attribute.itemSize;
    this.elementOf.forEach((element, vertex) => {
      for (let k = 0; k < each; ++k) attribute.array[each * vertex + k] = values[each * element + k];
    });
    attribute.needsUpdate = true;
  }

  markFailures(failures, brokenFloes) {
    const {floeOf, outlines} = this.replay;
    const failed = new Map();
    const mark = (element, bits) => failed.set(element, failed.get(element) | bits);
    for (const [, , , a, edgeOfA, b, edgeOfB] of failures) {
      mark(a, edgeOfA);
      mark(b, edgeOfB);
    }
    const attribute = this.geometry.attributes.edge;
    this.elementOf.forEach((element, vertex) => {
      const edge = this.edgeOf[vertex];
      const isRim = outlines[element] >> edge & 1;
      attribute.array[vertex] = failed.get(element) >> edge & 1 ? 255
        : !isRim ? 0 : brokenFloes.has(floeOf[element]) ? 191 : 128;
    });
    attribute.needsUpdate = true;
  }
}
