'use strict';
// The four pictures. Each has two canvases, one of all members and one of those that are marked above it, so that
// brushing draws only the second; and above both an SVG of D3 with axes and brush. Many points are set as pixels, since
// 100,000 circles take a canvas a second.

const manyPoints = 4000;   // from here on points are squares of pixels
const drawnLines = 40;     // of load histories
const drawnMembers = 1000; // of parallel coordinates

// Colours of the style sheet as it is now, light or dark, and of each member by what is chosen.
class Colours {
  constructor(data) {
    this.data = data;
    this.index = new Uint8Array(data.count); // of each member in the table
    this.column = null;
    this.read();
  }

  read() {
    const style = getComputedStyle(document.documentElement);
    this.css = name => style.getPropertyValue(`--${name}`).trim();
    this.by(this.column);
  }

  // A column, or null: all alike.
  by(column) {
    this.column = column;
    const {index} = this;
    if (!column) {
      this.table = [this.css('mark')];
      index.fill(0);
    } else if (column.categories.length > 0 && column.categories.length <= 6) {
      this.table = column.categories.map((_, k) => this.css(`c${k}`));
      this.table.push(this.css('rest'));
      column.values.forEach((value, i) => { index[i] = value === value ? value : column.categories.length; });
    } else {
      const ramp = d3.scale.linear().domain([0, 127, 254])
        .range([this.css('low'), this.css('middle'), this.css('high')]).interpolate(d3.interpolateLab);
      this.table = d3.range(255).map(ramp).concat(this.css('rest'));
      const scale = (column.log && column.positive ? d3.scale.log() : d3.scale.linear())
        .domain([column.low, column.high === column.low ? column.low + 1 : column.high]).range([0, 254]);
      column.values.forEach((value, i) => { index[i] = value === value ? Math.round(scale(value)) : 255; });
    }
    this.pixels = Uint32Array.from(this.table, colour => pixelOf(colour));
    this.rest = this.css('rest');
  }

  of(member) {
    return this.table[this.index[member]];
  }
}

// As a canvas has it in memory, little endian.
function pixelOf(colour) {
  const {r, g, b} = d3.rgb(colour);
  return (255 << 24 | b << 16 | g << 8 | r) >>> 0;
}

class Plot {
  // `margin`: px, of the axes.
  constructor(host, explorer, margin) {
    this.host = host;
    this.explorer = explorer;
    this.margin = margin;
    this.base = host.appendChild(document.createElement('canvas'));
    this.top = host.appendChild(document.createElement('canvas'));
    this.svg = d3.select(host).append('svg');
    this.layer = this.svg.append('g');
  }

  // Takes the size that the host has now.
  fit() {
    const {margin, host} = this;
    this.width = Math.max(40, host.clientWidth - margin.left - margin.right);
    this.height = Math.max(40, host.clientHeight - margin.top - margin.bottom);
    this.ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.base, this.top]) {
      canvas.width = Math.round(this.width * this.ratio);
      canvas.height = Math.round(this.height * this.ratio);
      Object.assign(canvas.style, {width: `${this.width}px`, height: `${this.height}px`, left: `${margin.left}px`,
        top: `${margin.top}px`});
    }
    this.fresh = new Set([this.base, this.top]);
    this.layer.attr('transform', `translate(${margin.left},${margin.top})`).selectAll('*').remove();
  }

  clean(canvas) {
    const context = canvas.getContext('2d');
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    // Not of one that was just made: on paper that would clear what lies below it too.
    if (!this.fresh.delete(canvas)) context.clearRect(0, 0, this.width, this.height);
    return context;
  }

  axis(scale, orient, at, column, count) {
    const axis = d3.svg.axis().scale(scale).orient(orient).ticks(count).tickSize(4);
    if (column && column.categories.length > 0) {
      const all = column.categories.length;
      const every = Math.ceil(all / Math.max(count, 2));
      axis.tickValues(d3.range(0, all, every)).tickFormat(k => shortened(column.categories[k], 14));
    } else if (scale.base) {
      axis.tickFormat(scale.tickFormat(count, d3.format(',g')));
    }
    return this.layer.append('g').attr('class', 'axis').attr('transform', at).call(axis);
  }

  title(words, x, y, anchor = 'start') {
    return this.layer.append('text').attr('class', 'title').attr('x', x).attr('y', y).attr('text-anchor', anchor)
      .text(words);
  }
}

function shortened(words, most) {
  return words.length > most ? words.slice(0, most - 1) + '…' : words;
}

// Of a column's values, with some room at both ends.
function scaleOf(column, isLog, range) {
  if (column.categories.length > 0) return d3.scale.linear().domain([column.low, column.high]).range(range);
  if (isLog && column.positive) {
    const room = (column.high / column.low) ** 0.03;
    return d3.scale.log().domain([column.low / room, column.high * room]).range(range);
  }
  const room = 0.03 * (column.high - column.low) || Math.max(1, Math.abs(column.high)) * 0.03;
  return d3.scale.linear().domain([column.low - room, column.high + room]).range(range);
}

// The part of a range that a scale has room for.
function within(scale, [low, high]) {
  const [a, b] = scale.domain();
  return [Math.min(b, Math.max(a, low)), Math.max(a, Math.min(b, high))];
}

// Points of a category stand beside each other, in the same order at every drawing.
function besideEachOther(member) {
  return ((member * 0.6180339887) % 1 - 0.5) * 0.5;
}

class Scatter extends Plot {
  draw() {
    this.fit();
    const {x, y, xLog, yLog, marks} = this.explorer;
    this.x = scaleOf(x, xLog, [0, this.width]);
    this.y = scaleOf(y, yLog, [this.height, 0]);
    this.axis(this.x, 'bottom', `translate(0,${this.height})`, x, Math.max(3, this.width / 90));
    this.axis(this.y, 'left', '', y, 6);
    this.title(x.heading, this.width, this.height + 32, 'end');
    this.title(y.heading, -this.margin.left + 4, -8);
    const count = this.explorer.data.count;
    this.xs = new Float32Array(count);
    this.ys = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
      this.xs[i] = this.x(x.values[i] + (x.categories.length > 0 ? besideEachOther(i) : 0));
      this.ys[i] = this.y(y.values[i] + (y.categories.length > 0 ? besideEachOther(i) : 0));
    }
    this.points(this.base, null);
    this.addBrush();
    this.pick = this.layer.append('circle').attr({r: 8, fill: 'none', 'stroke-width': 2.5, 'pointer-events': 'none'});
    this.drawMarked(marks);
  }

  addBrush() {
    const {explorer} = this;
    this.brush = d3.svg.brush().x(this.x).y(this.y).clamp([true, true]);
    const place = this.layer.append('g').attr('class', 'brush');
    let begin = null;
    this.brush.on('brushstart', () => { begin = d3.mouse(place.node()); });
    this.brush.on('brush', () => {
      if (this.brush.empty()) return;
      const [[x0, y0], [x1, y1]] = this.brush.extent();
      explorer.setRanges([[explorer.x, [x0, x1]], [explorer.y, [y0, y1]]], this);
    });
    this.brush.on('brushend', () => {
      const end = d3.mouse(place.node());
      if (begin && Math.hypot(end[0] - begin[0], end[1] - begin[1]) < 4) this.pickAt(end);
      this.showBrush();
    });
    this.brushPlace = place.call(this.brush);
    this.showBrush();
  }

  // As the ranges have it, which other pictures set too.
  showBrush() {
    const {x, y, marks: {ranges}} = this.explorer;
    const [of_x, of_y] = [ranges.get(x.place), ranges.get(y.place)];
    if (of_x || of_y) {
      const [a, b] = within(this.x, of_x || this.x.domain());
      const [c, d] = within(this.y, of_y || this.y.domain());
      this.brush.extent([[a, c], [b, d]]);
    } else {
      this.brush.clear();
    }
    this.brushPlace.call(this.brush);
  }

  pickAt([x, y]) {
    let nearest = -1;
    let least = 20 ** 2;
    for (let i = 0; i < this.xs.length; ++i) {
      const far = (this.xs[i] - x) ** 2 + (this.ys[i] - y) ** 2;
      if (far < least) [nearest, least] = [i, far];
    }
    if (nearest >= 0) this.explorer.pick(nearest);
  }

  // The marked member that follows the picked one across or up; sign: 1 or -1.
  next(along, sign) {
    const at = along === 'x' ? this.xs : this.ys;
    const {picked, marks: {marked}} = this.explorer;
    let best = -1;
    const after = i => sign * (at[i] - at[picked]) || sign * (i - picked);
    for (let i = 0; i < at.length; ++i) {
      if (!marked[i] || Number.isNaN(at[i]) || i === picked) continue;
      if (picked >= 0 && after(i) <= 0) continue;
      if (best < 0 || (sign * (at[i] - at[best]) || sign * (i - best)) < 0) best = i;
    }
    return best;
  }

  points(canvas, marked) {
    const context = this.clean(canvas);
    const {colours} = this.explorer;
    const {xs, ys} = this;
    if (xs.length > manyPoints) {
      this.pixelPoints(context, marked, colours);
      return;
    }
    const radius = xs.length > 500 ? 2.6 : 4;
    for (let i = 0; i < xs.length; ++i) {
      if (marked && !marked[i] || Number.isNaN(xs[i]) || Number.isNaN(ys[i])) continue;
      context.fillStyle = marked ? colours.of(i) : colours.rest;
      context.beginPath();
      context.arc(xs[i], ys[i], radius, 0, 2 * Math.PI);
      context.fill();
    }
  }

  pixelPoints(context, marked, colours) {
    const {xs, ys, ratio} = this;
    const {width, height} = context.canvas;
    const image = context.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    const size = Math.max(2, Math.round(2 * ratio));
    const rest = pixelOf(colours.rest);
    for (let i = 0; i < xs.length; ++i) {
      if (marked && !marked[i]) continue;
      const left = Math.round(xs[i] * ratio) - (size >> 1);
      const top = Math.round(ys[i] * ratio) - (size >> 1);
      if (!(left >= 0 && top >= 0 && left + size <= width && top + size <= height)) continue;
      const pixel = marked ? colours.pixels[colours.index[i]] : rest;
      for (let row = top; row < top + size; ++row) pixels.fill(pixel, row * width + left, row * width + left + size);
    }
    context.putImageData(image, 0, 0);
  }

  drawMarked(marks) {
    this.points(this.top, marks.marked);
    this.showPicked();
  }

  showPicked() {
    const {picked, colours} = this.explorer;
    this.pick.style('display', picked < 0 ? 'none' : null).attr('stroke', colours.css('pick'));
    if (picked >= 0) this.pick.attr({cx: this.xs[picked], cy: this.ys[picked]});
  }
}

class Histogram extends Plot {
  draw() {
    const {spread, data, marks} = this.explorer;
    const cases = data.header.cases.length;
    this.rows = cases <= 6 ? cases : 1;
    this.host.style.height = `${Math.max(15, 4.4 * this.rows + 3)}rem`;
    this.fit();
    const bins = spread.categories.length || Math.min(40, Math.max(8, Math.round(Math.sqrt(data.count) * 1.5)));
    this.bins = bins;
    this.x = scaleOf(spread, this.explorer.spreadLog, [0, this.width]);
    this.bin = new Int16Array(data.count);
    for (let i = 0; i < data.count; ++i) {
      const at = Math.floor(this.x(spread.values[i]) / this.width * bins);
      this.bin[i] = Number.isNaN(spread.values[i]) ? -1 : Math.min(bins - 1, Math.max(0, at));
    }
    this.all = this.counted(null);
    this.most = this.all.map(counts => d3.max(counts) || 1);
    this.axis(this.x, 'bottom', `translate(0,${this.height})`, spread, Math.max(3, this.width / 90));
    this.title(spread.heading, this.width, this.height + 32, 'end');
    for (let row = 0; row < this.rows; ++row) {
      const scale = d3.scale.linear().domain([0, this.most[row]]).range([this.bottom(row), this.roof(row)]);
      this.axis(scale, 'left', '', null, 2);
      if (this.rows > 1) this.title(shortened(data.header.cases[row], 34), this.width, this.roof(row) + 2, 'end');
    }
    this.bars(this.base, this.all, () => this.explorer.colours.rest);
    this.addBrush();
    this.drawMarked(marks);
  }

  roof(row) { return this.height * row / this.rows + 10; }
  bottom(row) { return this.height * (row + 1) / this.rows; }

  counted(marked) {
    const counts = d3.range(this.rows).map(() => new Uint32Array(this.bins));
    const {cases} = this.explorer.data;
    for (let i = 0; i < this.bin.length; ++i)
      if (this.bin[i] >= 0 && (!marked || marked[i])) ++counts[this.rows > 1 ? cases[i] : 0][this.bin[i]];
    return counts;
  }

  bars(canvas, all, colour) {
    const context = this.clean(canvas);
    const each = this.width / this.bins;
    all.forEach((counts, row) => {
      context.fillStyle = colour(row);
      const high = this.bottom(row) - this.roof(row);
      counts.forEach((count, k) => {
        const tall = high * count / this.most[row];
        context.fillRect(k * each + 0.5, this.bottom(row) - tall, Math.max(1, each - 1), tall);
      });
    });
  }

  addBrush() {
    const {explorer} = this;
    this.brush = d3.svg.brush().x(this.x).on('brush', () => {
      explorer.setRanges([[explorer.spread, this.brush.empty() ? null : this.brush.extent()]], this);
    });
    this.brushPlace = this.layer.append('g').attr('class', 'brush').call(this.brush);
    this.brushPlace.selectAll('rect').attr('height', this.height);
    this.showBrush();
  }

  showBrush() {
    const range = this.explorer.marks.ranges.get(this.explorer.spread.place);
    if (range) this.brush.extent(within(this.x, range));
    else this.brush.clear();
    this.brushPlace.call(this.brush);
  }

  drawMarked(marks) {
    const {colours} = this.explorer;
    const byCase = this.rows > 1 && colours.column && colours.column.key === 'case';
    this.bars(this.top, this.counted(marks.marked), row => byCase ? colours.table[row] : colours.css('mark'));
  }
}

class Histories extends Plot {
  draw() {
    this.fit();
    const {data, marks, data: {history, header: {history: about}}} = this.explorer;
    let low = 0;
    let high = 0;
    for (const value of history) {
      if (value === noHistory) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    this.x = d3.scale.linear().domain([0, d3.max(about.ends)]).range([0, this.width]);
    this.y = d3.scale.linear().domain([low * about.quantum, 1.03 * high * about.quantum]).range([this.height, 0]);
    this.axis(this.x, 'bottom', `translate(0,${this.height})`, null, Math.max(3, this.width / 90));
    this.axis(this.y, 'left', '', null, 5);
    this.title('time, s', this.width, this.height + 32, 'end');
    this.title(`surge load, ${about.unit}`, -this.margin.left + 4, -8);
    const every = Math.max(1, data.count / drawnLines);
    const context = this.clean(this.base);
    for (let i = 0; i < data.count; i += every) this.line(context, Math.floor(i), this.explorer.colours.rest, 0.7);
    this.addBrush();
    this.drawMarked(marks);
  }

  line(context, member, colour, width) {
    const {cases, history, header: {history: {parts, ends, quantum}}} = this.explorer.data;
    const each = ends[cases[member]] / parts;
    const first = 2 * member * parts;
    if (history[first] === noHistory) return;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    for (let part = 0; part < parts; ++part)
      for (let k = 0; k < 2; ++k) { // up in one part, down in the next
        const value = history[first + 2 * part + (k + part) % 2];
        if (value !== noHistory) context.lineTo(this.x((part + 0.25 + 0.5 * k) * each), this.y(quantum * value));
      }
    context.stroke();
  }

  addBrush() {
    const {explorer} = this;
    this.brush = d3.svg.brush().x(this.x).y(this.y).on('brush', () => {
      const [[from, low], [to, high]] = this.brush.extent();
      explorer.setWindow(this.brush.empty() ? null : {from, to, low, high}, this);
    });
    this.brushPlace = this.layer.append('g').attr('class', 'brush');
    this.showBrush();
  }

  showBrush() {
    const {window: asked} = this.explorer.marks;
    if (asked) this.brush.extent([[asked.from, asked.low], [asked.to, asked.high]]);
    else this.brush.clear();
    this.brushPlace.call(this.brush);
  }

  drawMarked(marks) {
    const {colours, picked, data} = this.explorer;
    const context = this.clean(this.top);
    const some = marks.some(drawnLines);
    context.globalAlpha = some.length > 12 ? 0.5 : 1;
    for (const member of some) this.line(context, member, colours.of(member), 0.8);
    context.globalAlpha = 1;
    if (picked >= 0) this.line(context, picked, colours.css('pick'), 2);
    this.said = some.length < marks.count ? `${some.length} of the ${marks.count.toLocaleString('en')} marked members are drawn. ` : '';
    if (data.header.history.thinned)
      this.said += `Of each of ${data.header.history.parts} parts of a run, the least and the largest load. `;
  }
}

class Parallel extends Plot {
  draw() {
    const {axes, data, marks} = this.explorer;
    this.host.style.minWidth = `${Math.max(1, axes.length) * 6.5}rem`;
    this.fit();
    this.place = d3.scale.linear().domain([0, Math.max(1, axes.length - 1)]).range([0, this.width]);
    this.scales = axes.map(column => scaleOf(column, column.log, [this.height, 0]));
    const every = Math.max(1, data.count / drawnMembers);
    const context = this.clean(this.base);
    context.globalAlpha = data.count > 200 ? 0.4 : 0.8;
    for (let i = 0; i < data.count; i += every) this.line(context, Math.floor(i), this.explorer.colours.rest, 1);
    context.globalAlpha = 1;
    this.brushes = axes.map((column, k) => this.addAxis(column, k));
    this.drawMarked(marks);
  }

  addAxis(column, k) {
    const scale = this.scales[k];
    this.axis(scale, k + 1 === this.scales.length && k > 0 ? 'right' : 'left', `translate(${this.place(k)},0)`, column, 5);
    const anchor = k === 0 ? 'start' : k + 1 === this.scales.length ? 'end' : 'middle';
    const at = k === 0 ? -this.margin.left + 4 : k + 1 === this.scales.length ? this.width + this.margin.right - 4 : this.place(k);
    this.title(column.heading, at, k % 2 ? -10 : -26, anchor);
    const brush = d3.svg.brush().y(scale).on('brush', () => {
      this.explorer.setRanges([[column, brush.empty() ? null : brush.extent()]], this);
    });
    const place = this.layer.append('g').attr('class', 'brush').attr('transform', `translate(${this.place(k)},0)`);
    const shown = {brush, place, column};
    this.showOne(shown);
    return shown;
  }

  showOne({brush, place, column}) {
    const range = this.explorer.marks.ranges.get(column.place);
    if (range) brush.extent(within(brush.y(), range));
    else brush.clear();
    place.call(brush).selectAll('rect').attr('x', -12).attr('width', 24);
  }

  showBrush() {
    for (const one of this.brushes) this.showOne(one);
  }

  line(context, member, colour, width) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    this.scales.forEach((scale, k) => {
      const {values, categories} = this.explorer.axes[k];
      const value = values[member] + (categories.length > 0 ? 0.6 * besideEachOther(member) : 0);
      if (value === value) context.lineTo(this.place(k), scale(value));
    });
    context.stroke();
  }

  drawMarked(marks) {
    const {colours, picked, data} = this.explorer;
    const context = this.clean(this.top);
    const some = marks.some(drawnMembers);
    context.globalAlpha = some.length > 200 ? 0.35 : 0.8;
    for (const member of some) this.line(context, member, colours.of(member), 1);
    context.globalAlpha = 1;
    if (picked >= 0) this.line(context, picked, colours.css('pick'), 2.5);
    this.said = 'Drag along an axis to mark. ' + (some.length < marks.count ?
      `${some.length.toLocaleString('en')} of the ${marks.count.toLocaleString('en')} marked members are drawn. ` : '');
    if (data.count > drawnMembers) this.said += 'Lines of others are as few.';
  }
}
