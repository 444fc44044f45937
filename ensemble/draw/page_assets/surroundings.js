'use strict';
// What the ice floats in and against: the structure, the fixed ice sheets and the water with its grid of metres.

// Polygons in triangles. Where neighbours lie almost in one plane the surface is shaded as round; its rims stay sharp.
function surfaceGeometry({points, polygons}) {
  const at = index => new THREE.Vector3().fromArray(points, 3 * index);
  const normals = polygons.map(polygon => {
    const sum = new THREE.Vector3();
    for (let k = 1; k + 1 < polygon.length; ++k)
      sum.add(at(polygon[k]).sub(at(polygon[0])).cross(at(polygon[k + 1]).sub(at(polygon[0]))));
    return sum.normalize();
  });
  const around = Array.from({length: points.length / 3}, () => []);
  polygons.forEach((polygon, p) => polygon.forEach(index => around[index].push(normals[p])));
  const positions = [];
  const shading = [];
  polygons.forEach((polygon, p) => {
    const add = index => {
      const normal = new THREE.Vector3();
      for (const other of around[index]) if (other.dot(normals[p]) > 0.95) normal.add(other);
      positions.push(...at(index).toArray());
      shading.push(...normal.normalize().toArray());
    };
    for (let k = 1; k + 1 < polygon.length; ++k) [polygon[0], polygon[k], polygon[k + 1]].forEach(add);
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(shading, 3));
  return geometry;
}

function makeStructure(header) {
  const group = new THREE.Group();
  const material = new THREE.MeshLambertMaterial({side: THREE.DoubleSide});
  group.add(new THREE.Mesh(surfaceGeometry(header.structure), material));
  const mark = towMark(header);
  group.add(mark);
  group.useTheme = () => {
    material.color.set(styled('structure'));
    mark.material.color.set(styled('mark'));
  };
  group.seeThrough = through => {
    material.transparent = through;
    material.opacity = through ? 0.35 : 1;
    material.depthWrite = !through;
  };
  return group;
}

// A triangle on top that points where the tow goes.
function towMark(header) {
  const {points, top: height} = header.structure;
  let radius = 0; // of the deck
  for (let i = 0; i < points.length; i += 3)
    if (Math.abs(points[i + 1] - height) < 1e-6) radius = Math.max(radius, Math.hypot(points[i], points[i + 2]));
  const ahead = Math.sign(header.tow.speed) || 1;
  const corners = [[0.9, 0], [0.68, -0.16], [0.68, 0.16]];
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(
    corners.flatMap(([x, z]) => [ahead * x * radius, height + 0.003 * radius, z * radius]), 3));
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({side: THREE.DoubleSide}));
}

function makeSheets(header) {
  const group = new THREE.Group();
  const material = new THREE.MeshLambertMaterial();
  const ink = new THREE.LineBasicMaterial();
  for (const {centre, half} of header.channel.sheets) {
    const box = new THREE.BoxBufferGeometry(2 * half[0], 2 * half[1], 2 * half[2]);
    const sheet = new THREE.Mesh(box, material);
    sheet.add(new THREE.LineSegments(new THREE.EdgesGeometry(box), ink));
    sheet.position.set(...centre);
    group.add(sheet);
  }
  group.useTheme = () => {
    material.color.set(styled('sheet'));
    ink.color.set(styled('rim'));
  };
  return group;
}

const waterVertexShader = `
varying vec3 vWorld;
void main() {
  vWorld = (modelMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * viewMatrix * vec4(vWorld, 1.0);
}`;

// Fades into the background far away; lines stand `cell` m apart, every tenth is stronger.
const waterFragmentShader = `
uniform vec3 water, background, ink, centre;
uniform float cell, reach, opacity;
varying vec3 vWorld;
float grid(float apart) {
  vec2 at = vWorld.xz / apart;
  vec2 pixel = fwidth(at);
  vec2 away = abs(fract(at - 0.5) - 0.5);
  vec2 lines = (1.0 - smoothstep(pixel * 0.5, pixel * 1.5, away)) * clamp(0.12 / pixel, 0.0, 1.0);
  return max(lines.x, lines.y);
}
void main() {
  float far = smoothstep(0.5 * reach, reach, distance(vWorld.xz, centre.xz));
  vec3 colour = mix(water, ink, 0.22 * max(grid(cell), 1.0 * grid(10.0 * cell)));
  gl_FragColor = vec4(mix(colour, background, far), mix(opacity, 1.0, far));
}`;

function makeWater(header) {
  const {begin, end, edge} = header.channel;
  const reach = 1.5 * (end - begin) + 8 * edge;
  const colour = () => ({value: new THREE.Color()});
  const material = new THREE.ShaderMaterial({
    vertexShader: waterVertexShader, fragmentShader: waterFragmentShader, extensions: {derivatives: true},
    transparent: true, depthWrite: false, side: THREE.DoubleSide,
    uniforms: {
      water: colour(), background: colour(), ink: colour(), cell: {value: cellSize(header)}, reach: {value: reach},
      opacity: {value: 0.5}, centre: {value: new THREE.Vector3()},
    },
  });
  const plane = new THREE.Mesh(new THREE.PlaneBufferGeometry(2 * reach, 2 * reach), material);
  plane.rotation.x = -Math.PI / 2;
  plane.position.x = 0.5 * (begin + end);
  material.uniforms.centre.value.copy(plane.position);
  plane.useTheme = () => {
    material.uniforms.water.value.set(styled('water'));
    material.uniforms.background.value.set(styled('far'));
    material.uniforms.ink.value.set(styled('ink'));
  };
  return plane;
}

// Metres between lines of the water: about the structure's radius, a power of ten.
function cellSize(header) {
  const {radius} = header.structure;
  return 10 ** Math.round(Math.log10(radius));
}

function makeLights() {
  const group = new THREE.Group();
  const sun = new THREE.DirectionalLight(0xffffff, 0.5);
  sun.position.copy(sunDirection);
  const fromBelow = new THREE.DirectionalLight(0xffffff, 0.25); // else undersides would be black
  fromBelow.position.set(0.5, -0.6, 0.8);
  group.add(sun, fromBelow, new THREE.HemisphereLight(0xffffff, 0xc4d2dc, 0.66));
  return group;
}
