'use strict';
// The load over time, or how a hull gives way to it, with a cursor that follows the ice and sets its time.

class Chart {
  constructor(canvas, {header, unit}, go) {
    this.canvas = canvas;
    this.header = header;
    this.unit = unit;
    this.component = 'surge';
    this.whole = false;
    const [run, part] = header.histories;
    this.hasPart = part.to > part.from && part.to - part.from < 0.95 * (run.to - run.from);
    const drag = event => {
      if (event.type === 'pointerdown') canvas.setPointerCapture(event.pointerId);
      if (event.buttons === 0) return;
      event.preventDefault();
      go(this.timeAt(event.offsetX));
    };
    canvas.addEventListener('pointerdown', drag);
    canvas.addEventListener('pointermove', drag);
  }

  get history() {
    const [run, part] = this.header.histories;
    return this.hasPart && !this.whole ? part : run;
  }

  // Pixels of the figure within the canvas.
  get frame() {
    const {clientWidth, clientHeight} = this.canvas;
    return {left: 58, right: clientWidth - 12, top: 10, bottom: clientHeight - 22};
  }

  timeAt(x) {
    const {left, right} = this.frame;
    const {from, to} = this.history;
    return from + (x - left) / (right - left) * (to - from);
  }

  x(time) {
    const {left, right} = this.frame;
    const {from, to} = this.history;
    return left + (time - from) / (to - from) * (right - left);
  }

  // Least and largest value of the axis, N, with the points between.
  range() {
    const {values} = this.history[this.component];
    let low = 0;
    let high = 1e-9;
    for (const value of values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return [low, high];
  }

  static ticks(low, high, most) {
    const step = roundNumber((high - low) / most);
    const all = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) all.push(k * step);
    return all;
  }

  draw(time) {
    this.drawBackground();
    const {context, frame} = this;
    const x = Math.round(this.x(time)) + 0.5;
    if (x < frame.left - 1 || x > frame.right + 1) return;
    context.strokeStyle = styled('cursor');
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x, frame.top - 4);
    context.lineTo(x, frame.bottom);
    context.stroke();
  }

  // All but the cursor; kept while nothing changes.
  drawBackground() {
    const {canvas} = this;
    const scale = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * scale);
    const height = Math.round(canvas.clientHeight * scale);
    const key = [width, height, this.component, this.whole, dark.matches].join();
    if (key !== this.key) {
      this.key = key;
      canvas.width = width;
      canvas.height = height;
      this.context = canvas.getContext('2d');
      this.context.scale(scale, scale);
      this.drawFigure();
      this.kept = document.createElement('canvas');
      this.kept.width = width;
      this.kept.height = height;
      this.kept.getContext('2d').drawImage(canvas, 0, 0);
    } else {
      this.context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
      this.context.drawImage(this.kept, 0, 0, canvas.clientWidth, canvas.clientHeight);
    }
  }

  drawFigure() {
    const {context, frame, history, header} = this;
    const [low, high] = this.range();
    const y = value => frame.bottom - (value - low) / (high - low) * (frame.bottom - frame.top);
    const across = (a, b, colour) => {
      context.fillStyle = colour;
      const left = Math.max(this.x(a), frame.left);
      const right = Math.min(this.x(b), frame.right);
      if (right > left) context.fillRect(left, frame.top, right - left, frame.bottom - frame.top);
    };
    across(...header.window, styled('window'));
    if (this.hasPart && this.whole) {
      const [, part] = header.histories;
      across(part.from, part.to, styled('part'));
    }
    context.font = '11px system-ui, sans-serif';
    context.lineWidth = 1;
    this.drawAxes(y, low, high);
    this.drawFailures(history);
    context.textAlign = 'left';
    context.fillText('analysis window', Math.max(this.x(header.window[0]), frame.left) + 6, frame.top + 7);
    context.strokeStyle = styled(header.hull_histories.some(one => one.key === this.component) ? 'ink' : this.component);
    context.lineJoin = 'round';
    context.lineWidth = 1.2;
    context.beginPath();
    const {steps, values} = history[this.component];
    for (let i = 0; i < steps.length; ++i) context.lineTo(this.x((steps[i] + 1) * header.step), y(values[i]));
    context.stroke();
  }

  drawAxes(y, low, high) {
    const {context, frame, history, header} = this;
    context.strokeStyle = styled('grid');
    context.fillStyle = styled('soft');
    context.textBaseline = 'middle';
    context.textAlign = 'right';
    const hull = header.hull_histories.find(one => one.key === this.component);
    const {name, newtons} = hull && hull.unit !== 'N' ? {name: hull.unit, newtons: 1} : this.unit;
    const many = Math.max(2, Math.floor((frame.bottom - frame.top) / 20));
    for (const tick of Chart.ticks(low, high, many)) {
      const at = Math.round(y(tick)) + 0.5;
      context.beginPath();
      context.moveTo(frame.left, at);
      context.lineTo(frame.right, at);
      context.stroke();
      context.fillText(`${+(tick / newtons).toPrecision(6)} ${name}`, frame.left - 6, at);
    }
    context.textAlign = 'center';
    const times = Chart.ticks(history.from, history.to, Math.max(2, (frame.right - frame.left) / 80));
    for (const tick of times) {
      const at = Math.min(this.x(tick), frame.right - 12);
      context.fillText(`${+tick.toPrecision(6)} s`, at, frame.bottom + 12);
    }
  }

  // A mark for each joint that fails.
  drawFailures(history) {
    const {context, frame} = this;
    context.strokeStyle = styled('failed');
    context.beginPath();
    for (const [time] of this.header.failures) {
      if (time < history.from || time > history.to) continue;
      context.moveTo(this.x(time), frame.bottom);
      context.lineTo(this.x(time), frame.bottom - 6);
    }
    context.stroke();
  }
}
