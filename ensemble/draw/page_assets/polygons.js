'use strict';
// Elements that are convex polygons: flat faces of triangles round the middle, each at one edge, and a side at each.

const polygonVertexShader = placedElement + `
attribute vec3 side;
attribute float edge, inwards;
varying float vEdge, vInwards;
void main() {
  place(position, side);
  vEdge = edge;
  vInwards = inwards;
}`;

// The distance to the edge is in shares of the element's size.
const polygonFragmentShader = drawnElement + `
varying float vEdge, vInwards;
void main() {
  vec3 colour = vTint;
  bool flatFace = abs(vSide.y) > 0.5;
  if (flatFace) line(colour, vEdge, vInwards, fwidth(vInwards));
  gl_FragColor = lit(colour, flatFace, vEdge);
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
    const add = (name, array, each, normalised) => this.geometry.setAttribute(name,
      new THREE.BufferAttribute(array, each, normalised).setUsage(THREE.DynamicDrawUsage));
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
    const failed = new Map();
    const mark = (element, bits) => failed.set(element, failed.get(element) | bits);
    for (const [, , , a, edgeOfA, b, edgeOfB] of failures) {
      mark(a, edgeOfA);
      mark(b, edgeOfB);
    }
    const attribute = this.geometry.attributes.edge;
    this.elementOf.forEach((element, vertex) => {
      const edge = this.edgeOf[vertex];
      attribute.array[vertex] = failed.get(element) >> edge & 1 ? 255 : lineOf(this.replay, element, edge, brokenFloes);
    });
    attribute.needsUpdate = true;
  }
}
