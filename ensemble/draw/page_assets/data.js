'use strict';
// Reads what the program put into the page: a header in JSON and six compressed streams, which ensemble/draw/
// replay_page.hpp describes. Positions stay whole numbers of quanta; the graphics card turns them into metres.

// Adds up the differences between frames. Elements lie together: x, y, z of one, then of the next; likewise the parts
// x, y, z, w of their quaternions, which is the order of the shaders.
function summedStates(low, high, frames, elements) {
  const places = new Int16Array(frames * elements * 3);
  const turns = new Int16Array(frames * elements * 4);
  for (let part = 0; part < 7; ++part) {
    const isPlace = part < 3;
    const into = isPlace ? places : turns;
    const each = isPlace ? 3 : 4;
    const offset = isPlace ? part : (part - 3 + 3) % 4; // w comes first in the stream
    for (let e = 0; e < elements; ++e) {
      let value = 0;
      for (let f = 0; f < frames; ++f) {
        const at = (f * 7 + part) * elements + e;
        value += low[at] | high[at] << 8;
        into[(f * elements + e) * each + offset] = value;
      }
    }
  }
  return {places, turns};
}

function summedPercent(differences, frames, elements) {
  for (let i = elements; i < frames * elements; ++i) differences[i] += differences[i - elements];
  return differences;
}

// Of each element: its floe, the edges on the outline of the floe as bits, its size in m (of a polygon its thickness alone), and a
// polygon's corners.
function laidOut(header) {
  const floeOf = new Int32Array(header.elements);
  const outlines = new Uint32Array(header.elements);
  const corners = new Array(header.elements).fill(null); // of elements that are no squares
  const sizes = new Float32Array(3 * header.elements);
  let element = 0;
  let floe = 0;
  for (const kind of header.ice)
    for (let last = floe + kind.floes; floe < last; ++floe)
      kind.outline.forEach((outline, index) => {
        floeOf[element] = floe;
        outlines[element] = outline;
        if (kind.corners) corners[element] = kind.corners[index];
        sizes.set(kind.element, 3 * element++);
      });
  return {floeOf, outlines, sizes, corners};
}

// Everything of the replay: header, layout, and by frame: times, loads, places, turns, utilisation, contacts, pieces.
async function readReplay() {
  const header = JSON.parse(document.getElementById('header').textContent);
  const {frames, elements} = header;
  const [low, high, utilisation, numbers, contacts, pieces] = await Promise.all(
    ['low', 'high', 'utilisation', 'numbers', 'contacts', 'pieces'].map(inflated));
  const number = new Float32Array(numbers);
  const times = new Float64Array(frames);
  const loads = new Float32Array(3 * frames);
  const firstContact = new Int32Array(frames + 1);
  for (let f = 0; f < frames; ++f) {
    times[f] = Math.round(number[5 * f] / header.step) * header.step; // single precision is not exact
    loads.set(number.subarray(5 * f + 1, 5 * f + 4), 3 * f);
    firstContact[f + 1] = firstContact[f] + number[5 * f + 4];
  }
  const {places, turns} = summedStates(new Uint8Array(low), new Uint8Array(high), frames, elements);
  return {
    header, frames, elements, ...laidOut(header), times, loads, firstContact, places, turns,
    utilisation: summedPercent(new Uint8Array(utilisation), frames, elements),
    contacts: new Int16Array(contacts),
    changes: new Int32Array(pieces),
  };
}

// How forces up to `largest` N are written.
function forceUnit(largest) {
  const [name, newtons] = largest < 5e3 ? ['N', 1] : largest < 1e6 ? ['kN', 1e3] : ['MN', 1e6];
  const decimals = largest < 10 * newtons ? 2 : 1;
  return {name, newtons, text: force => `${(force / newtons).toFixed(decimals).replace(/^-(0\.0+)$/, '$1')} ${name}`};
}

class Replay {
  constructor(data) {
    Object.assign(this, data);
    this.pieces = new Int32Array(this.elements);
    this.begin = this.times[0];
    this.end = this.times[this.frames - 1];
    const loads = Array.from(this.times, (_, f) => this.loadAt(f));
    this.sums = loads.map(load => load.sum);
    this.surges = loads.map(load => load.surge);
    this.unit = forceUnit(Math.max(...this.sums));
  }

  // The last frame at or before a time.
  frameAt(time) {
    let low = 0;
    let high = this.frames - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  nearestFrame(time) {
    const before = this.frameAt(time);
    const after = Math.min(before + 1, this.frames - 1);
    return time - this.times[before] <= this.times[after] - time ? before : after;
  }

  // Force of the world, and its parts along the structure's axes: ahead, up and to starboard.
  loadAt(frame) {
    const force = [...this.loads.subarray(3 * frame, 3 * frame + 3)];
    const {yaw, pitch, roll} = this.structureAt(this.times[frame]);
    const turn = new THREE.Euler(roll, yaw, pitch, 'YZX');
    const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(axis => new THREE.Vector3(...axis).applyEuler(turn).toArray());
    const [ahead, up, starboard] = axes.map(axis => axis.reduce((sum, part, i) => sum + part * force[i], 0));
    return {force, axes, surge: -ahead, sway: starboard, heave: up, sum: Math.hypot(...force)};
  }

  // A load that few frames exceed, N: it sets how long arrows are.
  strongLoad() {
    const sorted = [...this.sums].sort((a, b) => a - b);
    return sorted[Math.floor(0.99 * (sorted.length - 1))] || 1;
  }

  frameOfLargestLoad() {
    return this.surges.indexOf(Math.max(...this.surges));
  }

  // The piece of each element, by the number of its first element.
  piecesAt(frame) {
    for (let i = 0; i < this.changes.length && this.changes[i] <= frame; i += 3)
      this.pieces[this.changes[i + 1]] = this.changes[i + 2];
    return this.pieces;
  }

  failuresUntil(time) {
    return this.header.failures.filter(failure => failure[0] <= time + 1e-9);
  }

  // Contact forces on the ice: [point, normal, friction, whether it is one of the structure], m and N.
  contactsAt(frame) {
    const {length, force, middle} = this.header.quanta;
    const found = [];
    for (let i = this.firstContact[frame]; i < this.firstContact[frame + 1]; ++i) {
      const raw = this.contacts.subarray(10 * i, 10 * i + 10);
      const three = (at, scale, shift) => [0, 1, 2].map(k => raw[at + k] * scale + shift[k]);
      found.push([three(0, length, middle), three(3, force, [0, 0, 0]), three(6, force, [0, 0, 0]), raw[9] === 1]);
    }
    return found;
  }

  contactsOfStructure(frame) {
    let count = 0;
    for (let i = this.firstContact[frame]; i < this.firstContact[frame + 1]; ++i) count += this.contacts[10 * i + 9];
    return count;
  }

  // Whether an element is in the field; in one without end they come and go.
  isThere(frame, element) {
    const first = 4 * (frame * this.elements + element);
    return [0, 1, 2, 3].some(k => this.turns[first + k] !== 0);
  }

  // m/s, from places at least 0.15 s apart: between near frames a quantum would count too much.
  speedsAt(frame, into) {
    let from = frame;
    let to = frame;
    while (this.times[to] - this.times[from] < 0.15 && (from > 0 || to < this.frames - 1)) {
      if (from > 0) --from;
      if (to < this.frames - 1) ++to;
    }
    const span = this.times[to] - this.times[from];
    const scale = span > 0 ? this.header.quanta.length / span : 0;
    const a = 3 * from * this.elements;
    const b = 3 * to * this.elements;
    for (let i = 0; i < 3 * this.elements; i += 3)
      into[i / 3] = !this.isThere(from, i / 3) || !this.isThere(to, i / 3) ? 0 : scale * Math.hypot(this.places[b + i] - this.places[a + i],
        this.places[b + i + 1] - this.places[a + i + 1], this.places[b + i + 2] - this.places[a + i + 2]);
    return into;
  }

  // {x, z, yaw, y, pitch, roll} of the structure: on the straight tow, or between the poses of the frames.
  structureAt(time) {
    const {tow, poses} = this.header;
    if (!poses) return {x: tow.start + tow.speed * time, z: 0, yaw: 0, y: 0, pitch: 0, roll: 0};
    let next = 1;
    while (next < poses.length - 1 && poses[next][0] < time) ++next;
    const [a, b] = [poses[Math.max(0, next - 1)], poses[Math.min(next, poses.length - 1)]];
    const share = b[0] > a[0] ? Math.min(1, Math.max(0, (time - a[0]) / (b[0] - a[0]))) : 0;
    const [x, z, yaw, y, pitch, roll] = [1, 2, 3, 4, 5, 6].map(i => a[i] + share * (b[i] - a[i]));
    return {x, z, yaw, y, pitch, roll};
  }
}
