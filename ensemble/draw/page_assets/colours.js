'use strict';
// What colours mean: of elements, arrows and lines, for light and dark screens.

const dark = window.matchMedia('(prefers-color-scheme: dark)');

function rgb(hex) {
  return [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16));
}

// Colour of the style sheet, so that figure, words and scene agree.
function styled(name) {
  return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

function hueColour(hue, saturation, lightness) {
  const part = n => {
    const k = (n + hue * 12) % 12;
    return 255 * (lightness - saturation * Math.min(lightness, 1 - lightness) *
      Math.max(-1, Math.min(k - 3, 9 - k, 1)));
  };
  return [part(0), part(8), part(4)];
}

// Between the colours of a list, for 0 to 1.
function between(stops, share) {
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const low = Math.min(Math.floor(at), stops.length - 2);
  return [0, 1, 2].map(k => stops[low][k] + (at - low) * (stops[low + 1][k] - stops[low][k]));
}

const viridis = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'].map(rgb);
const heat = ['#f3f6f8', '#fde8a9', '#fdae61', '#e34a33', '#7a0177'].map(rgb);
const crack = rgb('#1f4fd8');

// 1, 2 or 5 times a power of ten, at least `value`.
function roundNumber(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map(k => k * power).find(k => k >= value * (1 - 1e-9));
}

// Of whole numbers from 0 at the indices that count; of equally frequent ones the least.
function mostFrequent(values, counted) {
  const counts = new Int32Array(1 + values.reduce((most, one) => Math.max(most, one), 0));
  values.forEach((one, i) => { if (one >= 0 && counted(i)) ++counts[one]; });
  return counts.reduce((best, count, one) => count > counts[best] ? one : best, 0);
}

class Colouring {
  constructor(replay) {
    this.replay = replay;
    this.kind = 'piece';
    this.fastest = roundNumber(1.2 * Math.abs(replay.header.tow.speed) || 0.1);
    this.speeds = new Float32Array(replay.elements);
    this.bytes = new Uint8Array(3 * replay.elements);
  }

  // Refills the bytes, three an element.
  at(frame, brokenFloes) {
    const fill = {piece: this.byPiece, speed: this.bySpeed, utilisation: this.byUtilisation}[this.kind];
    fill.call(this, frame, brokenFloes);
    return this.bytes;
  }

  byPiece(frame, brokenFloes) {
    const pieces = this.replay.piecesAt(frame);
    const {floeOf, header: {sheet}} = this.replay;
    const whole = sheet ? mostFrequent(pieces, e => this.replay.isThere(frame, e)) : -1;
    for (let e = 0; e < this.replay.elements; ++e) {
      const broken = sheet ? pieces[e] !== whole : brokenFloes.has(floeOf[e]);
      const random = (k => k - Math.floor(k))((broken ? pieces[e] : sheet ? 0 : floeOf[e]) * 0.618034);
      const colour = broken
        ? hueColour(0.02 + 0.93 * random, 0.62, 0.7) : hueColour(0.57, 0.35, 0.86 + 0.09 * random);
      this.bytes.set(colour, 3 * e);
    }
  }

  bySpeed(frame) {
    this.replay.speedsAt(frame, this.speeds);
    for (let e = 0; e < this.replay.elements; ++e)
      this.bytes.set(between(viridis, this.speeds[e] / this.fastest), 3 * e);
  }

  byUtilisation(frame) {
    const first = frame * this.replay.elements;
    for (let e = 0; e < this.replay.elements; ++e) {
      const used = this.replay.utilisation[first + e] / 100;
      this.bytes.set(used > 1 ? crack : between(heat, used), 3 * e);
    }
  }

  // Markup that explains the colours; units included.
  legend() {
    const bar = stops => `<span class="bar" style="background:linear-gradient(90deg,${
      stops.map(stop => `rgb(${stop})`)})"></span>`;
    const sample = (colour, words) => `<li><span class="sample" style="background:${colour}"></span>${words}</li>`;
    const css = colour => `rgb(${colour.map(Math.round)})`;
    const line = (name, words) => `<li><span class="line" style="background:var(--${name})"></span>${words}</li>`;
    const own = {
      piece: sample(css(hueColour(0.57, 0.35, 0.9)), this.replay.header.sheet ? 'level ice' : 'whole floe') +
        sample(`linear-gradient(90deg,${[0.1, 0.35, 0.75].map(h => css(hueColour(h, 0.62, 0.7)))})`,
          this.replay.header.sheet ? 'pieces that broke off, a colour each' : 'pieces of a broken floe, a colour each'),
      speed: `<li>speed 0 ${bar(viridis)} ${this.fastest} m/s</li>`,
      utilisation: `<li>worst joint, share of its strength: 0 ${bar(heat)} 100 %</li>` +
        sample(css(crack), 'an open crack softens'),
    }[this.kind];
    return `<ul>${own}${line('failed', 'failed joint')}${line('broken', 'outline of a broken floe')}</ul>`;
  }
}
