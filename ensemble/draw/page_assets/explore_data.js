'use strict';
// Reads what the program put into the page (ensemble/draw/explore_page.hpp): done members as columns of numbers, and
// their thinned load histories. Everything that is marked is a range of a column, or a window of time and load.

async function readMembers() {
  const header = JSON.parse(document.getElementById('header').textContent);
  const [members, columns, history] = await Promise.all([
    inflated('members'), inflated('columns'), header.history.kept > 0 ? inflated('history') : null]);
  const count = header.done;
  const numbers = new Int32Array(members, 0, count);
  const cases = new Int32Array(members, 4 * count, count);
  const all = header.columns.map((about, k) => {
    const values = new Float32Array(columns, 4 * count * k, count);
    let low = Infinity;
    let high = -Infinity;
    let whole = true;
    let least = Infinity; // above 0
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
      if (value > 0 && value < least) least = value;
      if (whole && value !== Math.round(value) && value === value) whole = false;
    }
    if (about.categories.length > 0) {
      low = -0.5;
      high = about.categories.length - 0.5;
    }
    return {...about, place: k, values, low, high, whole, positive: low > 0,
      heading: about.unit ? `${about.words}, ${about.unit}` : about.words};
  });
  return {header, count, numbers, cases, columns: all, history: history && new Int16Array(history)};
}

const noHistory = -32768;

// Which members are marked: those in all ranges. A range is of a column (by its place), in its values.
class Marks {
  constructor(data) {
    this.data = data;
    this.ranges = new Map();
    this.window = null; // of the histories: {from, to} s, {low, high} of the load
    this.marked = new Uint8Array(data.count).fill(1);
    this.count = data.count;
  }

  get any() {
    return this.ranges.size > 0 || this.window !== null;
  }

  update() {
    const {marked} = this;
    marked.fill(1);
    for (const [place, [low, high]] of this.ranges) {
      const {values, categories} = this.data.columns[place];
      // In single precision, as the values are: a limit that is typed as 0.3 holds the value 0.3. Points of a category
      // stand up to 0.25 beside its place.
      const from = categories.length > 0 ? Math.ceil(low - 0.25) : Math.fround(low);
      const to = categories.length > 0 ? Math.floor(high + 0.25) : Math.fround(high);
      for (let i = 0; i < marked.length; ++i)
        if (!(values[i] >= from && values[i] <= to)) marked[i] = 0;
    }
    if (this.window) this.keepThoseInWindow();
    let count = 0;
    for (let i = 0; i < marked.length; ++i) count += marked[i];
    this.count = count;
  }

  keepThoseInWindow() {
    const {history, header: {history: {parts, ends, quantum}}, cases} = this.data;
    const {from, to, low, high} = this.window;
    for (let i = 0; i < this.marked.length; ++i) {
      if (!this.marked[i]) continue;
      const each = ends[cases[i]] / parts; // s
      const first = Math.max(0, Math.floor(from / each));
      const last = Math.min(parts - 1, Math.ceil(to / each) - 1);
      let inside = 0;
      for (let part = first; part <= last && !inside; ++part) {
        const at = 2 * (i * parts + part);
        if (history[at] !== noHistory && history[at] * quantum <= high && history[at + 1] * quantum >= low) inside = 1;
      }
      this.marked[i] = inside;
    }
  }

  // At most `most` marked members, evenly picked in member order.
  some(most) {
    const picked = [];
    const every = Math.max(1, this.count / most);
    let seen = 0;
    for (let i = 0; i < this.marked.length && picked.length < most; ++i)
      if (this.marked[i] && seen++ >= picked.length * every) picked.push(i);
    return picked;
  }
}

// A value as people read it: whole numbers as they are, others with four digits.
function valueText(column, value) {
  if (!Number.isFinite(value)) return '–';
  if (column.categories.length > 0) return column.categories[value];
  if (column.whole) return String(value);
  return Math.abs(value) >= 1e4 || Math.abs(value) < 1e-3 && value !== 0 ? Number(value.toPrecision(4)).toString()
                                                                        : String(Number(value.toPrecision(4)));
}
