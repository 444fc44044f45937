'use strict';
// What the ice floats in and against: the structure, the fixed ice sheets and the water with its grid of metres.

// A part of the profile each, so that its rims stay sharp.
function makeStructure(header) {
  const group = new THREE.Group();
  const material = new THREE.MeshLambertMaterial({side: THREE.DoubleSide});
  const profile = header.profile.map(([height, radius]) => new THREE.Vector2(radius, height));
  const bottom = new THREE.Vector2(0, profile[0].y);
  const top = new THREE.Vector2(0, profile[profile.length - 1].y);
  const outline = [bottom, ...profile, top];
  for (let i = 1; i < outline.length; ++i)
    group.add(new THREE.Mesh(new THREE.LatheBufferGeometry([outline[i - 1], outline[i]], 96), material));
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
  const [height, radius] = header.profile[header.profile.length - 1];
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
  const radius = Math.max(...header.profile.map(([, r]) => r));
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
