'use strict';
// The member that is picked, in numbers, as a history and as commands; and the list of those that are marked.

const listed = 20; // marked members with the largest value

function element(name, text, attributes = {}) {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

class PickedMember {
  constructor(host, explorer) {
    this.host = host;
    this.explorer = explorer;
  }

  draw() {
    const {host, explorer, explorer: {picked, data}} = this;
    host.replaceChildren();
    if (picked < 0) {
      host.append(element('h2', 'No member is picked'), element('p', 'Click a point, press an arrow key on the points, or ' +
        'choose one of the list below. Its numbers, its history and the commands that replay it stand here.', {class: 'hint'}));
      return;
    }
    const number = data.numbers[picked];
    const cases = data.header.cases;
    host.append(element('h2', `Member ${number.toLocaleString('en')}`));
    if (cases.length > 1)
      host.append(element('p', `${cases[data.cases[picked]]}; arrangement ${Math.floor(number / cases.length)}`));
    this.addHistory();
    const shown = data.columns.filter(column => column.kind !== 'place');
    const first = shown.filter(column => column.kind === 'input' || explorer.headlines.includes(column) ||
      column === explorer.x || column === explorer.y).slice(0, 12);
    host.append(this.numbers(first));
    this.addCommands(number);
    const rest = element('details');
    rest.append(element('summary', `All ${shown.length} numbers`), this.numbers(shown));
    host.append(rest);
  }

  numbers(columns) {
    const list = element('dl');
    for (const column of columns) {
      const value = valueText(column, column.values[this.explorer.picked]);
      list.append(element('dt', column.words, {title: column.about}),
                  element('dd', column.unit && value !== '–' ? `${value} ${column.unit}` : value));
    }
    return list;
  }

  addHistory() {
    const {explorer, explorer: {picked, data, colours, data: {header: {history: about}}}} = this;
    if (!explorer.histories) return;
    const {parts, quantum, ends, windows, unit} = about;
    const first = 2 * picked * parts;
    if (data.history[first] === noHistory) return;
    const plot = new Plot(this.host.appendChild(element('div', undefined, {class: 'plot'})), explorer,
                          {left: 44, right: 8, top: 18, bottom: 32});
    plot.fit();
    const own = data.history.subarray(first, first + 2 * parts);
    plot.x = d3.scale.linear().domain([0, ends[data.cases[picked]]]).range([0, plot.width]);
    plot.y = d3.scale.linear().domain([Math.min(0, d3.min(own)) * quantum, 1.03 * d3.max(own) * quantum]).nice()
      .range([plot.height, 0]);
    const context = plot.clean(plot.base);
    const [from, to] = windows[data.cases[picked]];
    context.fillStyle = colours.css('window');
    context.fillRect(plot.x(from), 0, plot.x(to) - plot.x(from), plot.height);
    Histories.prototype.line.call(plot, context, picked, colours.css('pick'), 1.2);
    plot.axis(plot.x, 'bottom', `translate(0,${plot.height})`, null, 5);
    plot.axis(plot.y, 'left', '', null, 3);
    plot.title('time, s; the measured window is shaded', plot.width, plot.height + 29, 'end');
    plot.title(`surge load, ${unit}`, -40, -6);
  }

  addCommands(number) {
    const {file} = this.explorer.data.header;
    const command = (words, text) => this.host.append(element('div', words), element('code', text));
    command('To watch it in a browser:', `floes replay ${file} ${number} -o member_${number}.html`);
    command('Pictures of its largest load and of its first floes:',
            `floes replay ${file} ${number} --worst -o worst_${number}.png\n` +
            `floes replay ${file} ${number} --at 0 --view plan -o first_${number}.png`);
  }
}

// Those with the largest value of what the points show upwards; a button picks.
function drawList(explorer) {
  const {data, marks, y, x, picked} = explorer;
  const best = [];
  for (let i = 0; i < data.count; ++i) {
    const value = y.values[i];
    if (!marks.marked[i] || Number.isNaN(value)) continue;
    if (best.length === listed && !(value > y.values[best[listed - 1]])) continue;
    let place = best.length;
    while (place > 0 && value > y.values[best[place - 1]]) --place;
    best.splice(place, 0, i);
    if (best.length > listed) best.pop();
  }
  document.getElementById('list-title').textContent = marks.count > listed
    ? `Of ${marks.count.toLocaleString('en')} marked members, those with the largest ${y.words}`
    : `Marked members, by their ${y.words}`;
  const shown = [y, ...[x, ...data.columns.filter(column => column.kind === 'input'), ...explorer.headlines]
    .filter((column, k, all) => column !== y && column.kind !== 'place' && all.indexOf(column) === k)].slice(0, 7);
  const withCase = data.header.cases.length > 1 && data.header.cases.length <= 6; // else inputs tell it better
  const head = element('tr');
  head.append(element('th', 'member'));
  if (withCase) head.append(element('th', 'case'));
  for (const column of shown) head.append(element('th', column.heading, {title: column.about}));
  const rows = best.map(i => {
    const row = element('tr', undefined, i === picked ? {class: 'is-picked'} : {});
    const button = element('button', String(data.numbers[i]), {type: 'button', 'aria-label': `Pick member ${data.numbers[i]}`});
    button.addEventListener('click', () => explorer.pick(i));
    const cell = element('td');
    cell.append(button);
    row.append(cell);
    if (withCase)
      row.append(element('td', shortened(data.header.cases[data.cases[i]], 34)));
    for (const column of shown) row.append(element('td', valueText(column, column.values[i])));
    return row;
  });
  document.getElementById('list').replaceChildren(head, ...rows);
}
