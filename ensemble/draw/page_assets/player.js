'use strict';
// What is shown at which time. Every picture begins here.

class Player {
  constructor(replay) {
    this.replay = replay;
    this.time = replay.header.start; // the largest load, if that was asked for
    this.speed = 1;
    this.playing = false;
    this.view = '';
    this.stage = new Stage($('scene'), replay, () => this.redraw());
    this.chart = new Chart($('chart'), replay, time => this.go(time));
    this.addHullHistories(replay.header.hull_histories);
    this.fillWords();
    this.controls = new Controls(this);
    this.setView('perspective');
    this.readHash();
  }

  // -- what the page says

  fillWords() {
    const {header, frames, begin, end} = this.replay;
    const apart = frames > 1 ? (end - begin) / (frames - 1) : 0;
    const rows = [['Arrangement', header.arrangement], ...header.conditions, ['Frames', `${frames}, ${+apart.toPrecision(2)} s apart`],
      ['Fingerprint', header.fingerprint]];
    $('conditions').replaceChildren(...rows.flatMap(([name, value]) => {
      const [dt, dd] = ['dt', 'dd'].map(tag => document.createElement(tag));
      dt.textContent = name;
      dd.textContent = value;
      return [dt, dd];
    }));
    $('configuration').textContent = header.configuration;
    $('scrub').min = begin;
    $('scrub').max = end;
    header.views.forEach((view, i) => {
      const button = document.createElement('button');
      button.textContent = view.name;
      button.dataset.view = view.name;
      button.title = `View ${view.name} (${i + 1})`;
      button.addEventListener('click', () => this.setView(view.name));
      $('views').append(button);
    });
    $('span').hidden = !this.chart.hasPart;
  }

  showLegend() {
    const {shows, colouring} = this.stage;
    const {speed} = this.replay.header.tow;
    const line = (colour, words) => `<li><span class="line" style="background:var(--${colour})"></span>${words}</li>`;
    const load = shows.load ? '<li>load on the structure:</li>' + line('surge', 'surge') + line('sway', 'sway') +
      line('heave', 'heave') + line('ink', 'sum') : '';
    const contacts = shows.contacts || shows.ice ? '<li>forces on floes:</li>' + line('normal', 'normal') +
      line('friction', 'friction') : '';
    const tow = line('tow', `through ice, ${+Math.abs(speed).toPrecision(3)} m/s`);
    const grid = `<li>water: lines ${cellSize(this.replay.header)} m apart</li>`;
    $('legend').innerHTML = colouring.legend() + `<ul>${load}${contacts}</ul><ul>${tow}${grid}</ul>`;
  }

  // Bars for a length and a force, both round numbers; they hold at the structure.
  showScales() {
    const {shows, newtons, longer, pixelsPerMetre} = this.stage;
    const {unit} = this.replay;
    const show = (id, pixelsEach, words) => {
      const amount = roundNumber(60 / pixelsEach);
      $(id).style.width = `${amount * pixelsEach}px`;
      $(id).textContent = words(amount);
    };
    show('length-scale', pixelsPerMetre, metres => `${+metres.toPrecision(1)} m`);
    show('force-scale', pixelsPerMetre * longer / newtons,
      force => `${+(force / unit.newtons).toPrecision(1)} ${unit.name}`);
    $('force-scale').hidden = !(shows.load || shows.contacts || shows.ice);
  }

  showValues(frame) {
    const {replay, time} = this;
    const load = replay.loadAt(frame);
    for (const name of ['surge', 'sway', 'heave', 'sum']) $(name).textContent = replay.unit.text(load[name]);
    const {floes, floes_there: there} = replay.header; // where floes come and go, of each frame
    const [broken, all] = there.length > 0 ? there[frame] : [this.stage.brokenFloes(time).size, floes];
    if (replay.header.sheet) $('broken-of').textContent = 'Pieces broken off';
    $('broken').textContent = `${broken} of ${all}`;
    const failures = replay.failuresUntil(time);
    const kept = !(replay.header.sheet && there.length > 0); // joints of a sheet without end have no number that stays
    $('failed').textContent = kept ? failures.length : '–';
    $('failed').title = replay.header.modes.map((mode, i) => [failures.filter(one => one[1] === i).length, mode])
      .filter(([count]) => count > 0).map(([count, mode]) => `${count} by ${mode.replace(/_/g, ' ')}`).join(', ');
    $('touching').textContent = replay.contactsOfStructure(frame);
    $('time').textContent = `${time.toFixed(2)} s`;
    $('scrub').value = time;
    $('scrub').setAttribute('aria-valuetext', `${time.toFixed(2)} seconds`);
  }

  // -- drawing

  redraw() {
    if (this.asked) return;
    this.asked = requestAnimationFrame(now => {
      this.asked = 0;
      this.advance(now);
      this.draw();
      if (this.playing) this.redraw();
    });
  }

  draw() {
    this.stage.draw(this.time);
    this.showScales();
    this.chart.draw(this.time);
    this.showValues(this.replay.nearestFrame(this.time));
  }

  advance(now) {
    if (!this.playing) return;
    const seconds = this.before === undefined ? 0 : Math.min((now - this.before) / 1000, 0.1);
    this.before = now;
    this.time = Math.min(this.time + seconds * this.speed, this.replay.end);
    if (this.time >= this.replay.end) this.play(false);
  }

  // -- time

  go(time) {
    this.time = Math.min(Math.max(time, this.replay.begin), this.replay.end);
    this.redraw();
  }

  play(playing) {
    if (playing && this.time >= this.replay.end) this.time = this.replay.begin;
    this.playing = playing;
    this.before = undefined;
    $('play').textContent = playing ? '❚❚' : '▶';
    $('play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
    this.redraw();
  }

  step(frames) {
    this.play(false);
    const {times, frames: all} = this.replay;
    const at = this.replay.nearestFrame(this.time);
    this.go(times[Math.min(Math.max(at + frames, 0), all - 1)]);
  }

  goToLargestLoad() {
    this.play(false);
    this.go(this.replay.times[this.replay.frameOfLargestLoad()]);
  }

  // -- what is shown

  setView(name) {
    if (!this.stage.look(name)) return;
    this.view = name;
    $('follow').checked = this.stage.orbit.follows;
    for (const button of $('views').children) button.setAttribute('aria-pressed', button.dataset.view === name);
    this.redraw();
  }

  zoom(factor) {
    this.stage.orbit.zoom(factor);
    this.redraw();
  }

  setFollow(follows) {
    this.stage.orbit.follow(follows, this.replay.structureAt(this.time));
    this.redraw();
  }

  setColour(kind) {
    $('colouring').value = kind;
    this.stage.colouring.kind = $('colouring').value || 'piece';
    this.showLegend();
    this.redraw();
  }

  setArrows() {
    this.stage.shows = {load: $('load-arrows').checked, contacts: $('contact-arrows').checked,
      ice: $('ice-arrows').checked};
    this.stage.longer = Number($('arrow-scale').value);
    this.showLegend();
    this.redraw();
  }

  // Of a hull that gives way the figure has more than the load, and first what the page was made for.
  addHullHistories(histories) {
    for (const {key, words, asked} of histories) $('component').add(new Option(words, key, false, asked));
    this.chart.component = $('component').value;
  }

  setComponent() {
    this.chart.component = $('component').value;
    this.redraw();
  }

  // #t=142.3&view=above&colour=speed
  readHash() {
    const asked = new URLSearchParams(location.hash.slice(1));
    if (asked.has('view')) this.setView(asked.get('view'));
    this.setColour(asked.get('colour') || this.stage.colouring.kind);
    const time = parseFloat(asked.get('t'));
    if (Number.isFinite(time)) this.go(time);
  }
}

// The page's one player, once the replay is unpacked; for whoever looks at the page from outside as well.
let player = null;

async function start() {
  try {
    if (!window.DecompressionStream) throw new Error('This browser is too old to unpack the replay; use one of 2023 or later.');
    player = new Player(new Replay(await readReplay()));
    $('notice').textContent = '';
    player.draw();
    document.body.dataset.ready = 'true';
  } catch (error) {
    $('notice').textContent = /WebGL/.test(error.message)
      ? 'This browser cannot draw in three dimensions (WebGL is off or missing).' : error.message;
  }
}

start();
