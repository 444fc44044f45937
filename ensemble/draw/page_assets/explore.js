'use strict';
// What is chosen, brushed and picked; tells the pictures. Whatever changes is drawn at the next frame, once.

class Explorer {
  constructor(data) {
    this.data = data;
    this.marks = new Marks(data);
    this.picked = -1; // the one with the largest load at first
    const quantities = data.columns.filter(column => column.kind === 'quantity');
    const numbers = ['mean_load', 'mean_maximum', 'maximum_load', 'failure_ratio', 'sd_load'];
    this.headlines = numbers.map(key => this.column(key)).filter(Boolean);
    const inputs = data.columns.filter(column => column.kind === 'input');
    this.y = this.headlines[1] || quantities[0] || data.columns[0];
    this.x = inputs.find(column => column.categories.length === 0) || this.headlines[0] || data.columns[0];
    if (data.header.cases.length <= 6 && this.headlines[0]) this.x = this.headlines[0];
    this.spread = this.y;
    this.xLog = this.x.log;
    this.yLog = false;
    this.spreadLog = false;
    this.axes = [...inputs, ...this.headlines].slice(0, 8);
    if (inputs.length > 6) this.axes = [...inputs.slice(0, 10), this.y];
    this.colours = new Colours(data);
    const byCase = this.column('case');
    this.colours.by(byCase && byCase.categories.length <= 6 ? byCase : inputs[1] || null);
    this.scatter = new Scatter(byId('scatter'), this, {left: 58, right: 14, top: 20, bottom: 36});
    this.histogram = new Histogram(byId('histogram'), this, {left: 44, right: 14, top: 6, bottom: 36});
    this.histories = data.history &&
      new Histories(byId('histories'), this, {left: 58, right: 14, top: 20, bottom: 36});
    this.parallel = this.axes.length > 1 ? new Parallel(byId('parallel'), this, {left: 62, right: 62, top: 42, bottom: 12}) : null;
    this.member = new PickedMember(byId('picked'), this);
    this.y.values.forEach((value, i) => {
      if (this.picked < 0 || value > this.y.values[this.picked]) this.picked = i;
    });
    this.plots = [this.scatter, this.histogram, this.histories, this.parallel].filter(Boolean);
    this.waiting = false;
    this.times = {draw: 0, brush: 0}; // ms, of the last ones
  }

  column(key) {
    return this.data.columns.find(column => column.key === key);
  }

  // Everything, after a change of size, colours or choices.
  drawAll() {
    const begin = performance.now();
    for (const plot of this.plots) plot.draw();
    drawLegend(this);
    this.member.draw();
    this.tell();
    this.times.draw = performance.now() - begin;
  }

  // [column, [low, high] or null] each; `by`: the picture that is being brushed, whose brush is as the hand has it.
  setRanges(ranges, by) {
    for (const [column, range] of ranges) {
      if (range) this.marks.ranges.set(column.place, range.slice());
      else this.marks.ranges.delete(column.place);
    }
    this.markLater(by);
  }

  setWindow(asked, by) {
    this.marks.window = asked;
    this.markLater(by);
  }

  clear() {
    if (byId('ranges').contains(document.activeElement)) document.activeElement.blur(); // or its box would stay
    this.marks.ranges.clear();
    this.marks.window = null;
    this.markLater(null);
  }

  markLater(by) {
    this.brushed = by;
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.mark();
    });
  }

  mark() {
    const begin = performance.now();
    this.marks.update();
    for (const plot of this.plots) {
      plot.drawMarked(this.marks);
      if (plot !== this.brushed) plot.showBrush();
    }
    this.tell();
    this.times.brush = performance.now() - begin;
  }

  pick(member) {
    this.picked = member;
    this.scatter.showPicked();
    if (this.histories) this.histories.drawMarked(this.marks);
    if (this.parallel) this.parallel.drawMarked(this.marks);
    this.member.draw();
    drawList(this);
  }

  tell() {
    const {marks, data, y} = this;
    const number = value => value.toLocaleString('en');
    const mean = of => {
      let sum = 0;
      let count = 0;
      for (let i = 0; i < data.count; ++i) {
        if (!of(i) || Number.isNaN(y.values[i])) continue;
        sum += y.values[i];
        ++count;
      }
      return `${valueText({...y, whole: false}, sum / count)}${y.unit ? ' ' + y.unit : ''}`;
    };
    const numeric = y.categories.length === 0;
    byId('marked').textContent = marks.any
      ? `${number(marks.count)} of ${number(data.count)} members are marked` +
        (numeric && marks.count > 0 ? `; mean of their ${y.words} ${mean(i => marks.marked[i])}, of all ${mean(() => true)}.` : '.')
      : `All ${number(data.count)} ${data.count === 1 ? 'member' : 'members'}` + (numeric ? `; mean of their ${y.words} ${mean(() => true)}.` : '.');
    byId('clear').disabled = !marks.any;
    byId('histogram-note').textContent = this.histogram.rows > 1 ? 'Grey: all members of the case. Drag to mark.'
      : 'Grey: all members' + (data.header.cases.length > 1 ? `, of ${number(data.header.cases.length)} cases together` : '') + '. Drag to mark.';
    if (this.histories) byId('histories-note').textContent = this.histories.said + 'Drag to mark the members whose load passes there.';
    if (this.parallel) byId('parallel-note').textContent = this.parallel.said;
    drawRanges(this);
    drawList(this);
  }
}

function byId(id) {
  return document.getElementById(id);
}

// What is marked, as numbers that can be typed.
function drawRanges(explorer) {
  const host = byId('ranges');
  if (host.contains(document.activeElement) && document.activeElement.type === 'number') return;
  host.replaceChildren();
  const {marks, data} = explorer;
  const addBox = (box, what, drop) => {
    const button = element('button', '×', {type: 'button', 'aria-label': `Drop the ${what}`});
    button.addEventListener('click', drop);
    box.append(button);
    host.append(box);
  };
  for (const [place, range] of marks.ranges) {
    const column = data.columns[place];
    const box = element('span', undefined, {class: 'range'});
    box.append(column.heading + (column.categories.length > 0 ? ' (places)' : ''));
    range.forEach((limit, k) => {
      const input = element('input', undefined, {type: 'number', step: 'any',
        'aria-label': `${column.words} ${k === 0 ? 'from' : 'to'}`});
      input.value = Number(limit.toPrecision(5));
      input.addEventListener('change', () => {
        const known = explorer.marks.ranges.get(place);
        if (!known || input.value === '') return;
        const changed = known.slice();
        changed[k] = Number(input.value);
        explorer.setRanges([[column, changed]], null);
      });
      box.append(k === 0 ? '' : 'to', input);
    });
    addBox(box, `range of ${column.words}`, () => explorer.setRanges([[column, null]], null));
  }
  if (!marks.window) return;
  const {from, to, low, high} = marks.window;
  const box = element('span', `surge load from ${low.toPrecision(3)} to ${high.toPrecision(3)} ${data.header.history.unit}, ` +
    `at ${from.toPrecision(3)} to ${to.toPrecision(3)} s`, {class: 'range'});
  addBox(box, 'window of the histories', () => explorer.setWindow(null, null));
}

function drawLegend({colours, colours: {column}}) {
  const host = byId('legend');
  host.replaceChildren();
  if (!column) return;
  if (column.categories.length > 0 && column.categories.length <= 6) {
    column.categories.forEach((words, k) => {
      const one = element('span');
      one.append(element('span', undefined, {class: 'swatch', style: `background:${colours.table[k]}`}), shortened(words, 40));
      host.append(one);
    });
    return;
  }
  const one = element('span', `${column.heading}: ${column.categories[0] || valueText(column, column.low)}`);
  one.append(element('span', undefined, {class: 'ramp'}), column.categories[column.categories.length - 1] || valueText(column, column.high));
  host.append(one);
}

function fillMenu(select, columns, chosen) {
  const groups = [['input', 'Inputs'], ['quantity', 'Quantities'], ['place', 'Which member']];
  for (const [kind, label] of groups) {
    const group = element('optgroup', undefined, {label});
    for (const column of columns.filter(one => one.kind === kind)) {
      const option = element('option', column.heading, {value: column.place, title: column.about});
      option.selected = column === chosen;
      group.append(option);
    }
    if (group.children.length > 0) select.append(group);
  }
}

function addMenus(explorer) {
  const {data} = explorer;
  const log = (id, key, of) => {
    const box = byId(id);
    box.checked = explorer[key];
    box.addEventListener('change', () => { explorer[key] = box.checked; explorer.scatter.draw(); });
    return () => { box.disabled = !explorer[of].positive; };
  };
  const enable = [log('x-log', 'xLog', 'x'), log('y-log', 'yLog', 'y')];
  const menu = (id, chosen, use) => {
    fillMenu(byId(id), data.columns, chosen);
    byId(id).addEventListener('change', event => {
      use(data.columns[event.target.value]);
      for (const one of enable) one();
    });
  };
  menu('x', explorer.x, column => { explorer.x = column; explorer.scatter.draw(); explorer.tell(); });
  menu('y', explorer.y, column => { explorer.y = column; explorer.scatter.draw(); explorer.tell(); });
  menu('spread', explorer.spread, column => { explorer.spread = column; explorer.histogram.draw(); explorer.tell(); });
  byId('colour').append(element('option', 'all alike', {value: ''}));
  menu('colour', explorer.colours.column, column => {
    explorer.colours.by(column || null);
    drawLegend(explorer);
    for (const plot of explorer.plots) plot.drawMarked(explorer.marks);
  });
  byId('add-range').append(element('option', '…', {value: ''}));
  menu('add-range', null, column => {
    byId('add-range').value = '';
    if (column) explorer.setRanges([[column, [column.low, column.high]]], null);
  });
  for (const one of enable) one();
  for (const column of data.columns.filter(one => one.kind !== 'place')) {
    const label = element('label');
    const box = element('input', undefined, {type: 'checkbox'});
    box.checked = explorer.axes.includes(column);
    box.addEventListener('change', () => {
      explorer.axes = box.checked ? [...explorer.axes, column] : explorer.axes.filter(one => one !== column);
      explorer.parallel.draw();
    });
    label.append(box, column.words);
    byId('axes').append(label);
  }
}

function addKeys(explorer) {
  byId('clear').addEventListener('click', () => explorer.clear());
  byId('scatter').addEventListener('keydown', event => {
    const ways = {ArrowRight: ['x', 1], ArrowLeft: ['x', -1], ArrowUp: ['y', -1], ArrowDown: ['y', 1]};
    if (!ways[event.key]) return;
    event.preventDefault();
    const next = explorer.scatter.next(...ways[event.key]);
    if (next >= 0) explorer.pick(next);
  });
  document.addEventListener('keydown', event => {
    if (event.key === 'Escape') explorer.clear();
  });
}

function drawNotes({data: {header, count}, histories}) {
  const number = value => value.toLocaleString('en');
  const also = [];
  if (header.failed.length > 0) also.push(`${number(header.failed.length)} failed`);
  if (header.missing > 0) also.push(`${number(header.missing)} not computed yet`);
  byId('about').textContent = `${number(count)} members of ${number(header.cases.length)} ` +
    `${header.cases.length === 1 ? 'case' : 'cases'}` + (also.length > 0 ? `; ${also.join(' and ')}, and not shown` : '') +
    '. What is brushed in one picture is marked in all.';
  const notes = byId('notes');
  const say = words => notes.append(element('p', words));
  say('Keys: Tab goes from control to control; on the points, arrow keys go from one marked member to the next across or ' +
      'up; Escape marks all again. Ranges can be typed.');
  if (header.alike.length > 0) say(`The same in all members, or without a value: ${header.alike.join(', ')}.`);
  if (header.left_out.length > 0) say(`Left out, since the page would be too large: ${header.left_out.join(', ')}.`);
  if (!histories) say('The campaign file keeps no load histories (analysis.history_steps).');
  else if (header.history.kept < count) say(`${number(header.history.kept)} members have a history.`);
  for (const one of header.failed.slice(0, 20)) say(`Member ${number(one.member)} failed: ${one.why}`);
  say('Scales, axes and brushes are by D3 3.5 (BSD 3-Clause, 240 kB, part of this page); points, bars and lines are ' +
      'drawn on canvases by the page itself. Nothing is asked of the network.');
}

function watchTheWindow(explorer) {
  const redraw = () => {
    explorer.colours.read();
    explorer.drawAll();
  };
  let due = 0;
  let width = document.body.clientWidth;
  window.addEventListener('resize', () => {
    if (document.body.clientWidth === width) return;
    width = document.body.clientWidth;
    clearTimeout(due);
    due = setTimeout(redraw, 100);
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  for (const [event, on] of [['beforeprint', true], ['afterprint', false]])
    window.addEventListener(event, () => {
      document.documentElement.classList.toggle('paper', on);
      redraw();
    });
}

let explorer = null;
readMembers().then(data => {
  explorer = new Explorer(data);
  if (!explorer.histories) byId('histories-section').hidden = true;
  addMenus(explorer);
  addKeys(explorer);
  drawNotes(explorer);
  explorer.drawAll();
  watchTheWindow(explorer);
  document.body.dataset.ready = 'yes';
}).catch(error => {
  byId('marked').textContent = `This page cannot be shown: ${error.message}`;
});
