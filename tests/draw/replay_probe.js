'use strict';
// Runs in the page of a replay (replay_in_browser.py): uses its controls and notes what happens. TIME and ELEMENT are
// numbers that the test puts in. Colours of the scene are counted on a small copy of the picture.

const notes = {};
const wait = () => new Promise(done => setTimeout(done, 20));
function picture() {
  player.draw();
  const scene = document.getElementById('scene');
  const copy = document.createElement('canvas');
  copy.width = 320;
  copy.height = 200;
  const context = copy.getContext('2d');
  context.drawImage(scene, 0, 0, 320, 200);
  return context.getImageData(0, 0, 320, 200).data;
}
function counts(pixels) {
  const found = {ice: 0, structure: 0, water: 0, red: 0};
  for (let i = 0; i < pixels.length; i += 4) {
    const [r, g, b] = pixels.subarray(i, i + 3);
    if (r > 200 && g > 210 && b > 215) ++found.ice;
    if (r > 150 && g > 100 && b < 90 && r > g + 20 && g > b + 40) ++found.structure;
    if (b > r + 15 && g > r) ++found.water;
    if (r > 170 && g < 70 && b < 70) ++found.red;
  }
  return found;
}
function change(a, b) {
  let pixels = 0;
  for (let i = 0; i < a.length; i += 4)
    if (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]) > 24) ++pixels;
  return pixels;
}
const words = id => document.getElementById(id).textContent;
function key(name) {
  document.body.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true}));
}
function set(id, value, event) {
  document.getElementById(id).value = value;
  document.getElementById(id).dispatchEvent(new Event(event));
}
async function probe() {
  for (let i = 0; i < 500 && !document.body.dataset.ready; ++i) await wait();
  notes.notice = words('notice');
  notes.hash = [words('time'), player.view];
  player.setView('perspective');
  const first = picture();
  notes.first = counts(first);
  notes.same = change(first, picture());
  set('scrub', TIME, 'input');
  const later = picture();
  notes.scrubbed = change(first, later);
  notes.time = words('time');
  const {times} = player.replay;
  const frame = player.replay.nearestFrame(player.time);
  set('scrub', 0.75 * times[frame] + 0.25 * times[frame + 1], 'input');
  player.draw();
  notes.share = player.stage.ice.material.uniforms.share.value;
  set('scrub', TIME, 'input');
  player.draw();
  notes.values = ['surge', 'sway', 'heave', 'sum', 'broken', 'touching'].map(words);
  notes.failed = Number(words('failed'));
  notes.places = [0, 1, 2].map(k => player.replay.header.quanta.middle[k] + player.replay.header.quanta.length *
    player.replay.places[3 * player.replay.nearestFrame(player.time) * player.replay.elements + 3 * ELEMENT + k]);
  notes.views = {};
  for (const [number, name] of ['perspective', 'above', 'side', 'below', 'plan'].entries()) {
    key(String(number + 1));
    notes.views[name] = [player.view, counts(picture())];
  }
  notes.apart = {};
  key('1');
  for (const colour of ['piece', 'speed', 'utilisation']) {
    set('colouring', colour, 'change');
    notes.apart[colour] = [change(later, picture()), words('legend')];
  }
  set('colouring', 'piece', 'change');
  key('f');
  notes.withoutArrows = change(later, picture());
  key('f');
  notes.withArrows = change(later, picture());
  key('ArrowRight');
  player.draw();
  notes.step = words('time');
  key('Home');
  player.draw();
  notes.home = words('time');
  key(' ');
  for (let i = 0; i < 1000 && player.time < 0.05; ++i) await wait();
  key(' ');
  notes.played = player.time;
  const chart = document.getElementById('chart').getBoundingClientRect();
  const middle = {clientX: chart.left + 58 + (chart.width - 70) / 2, clientY: chart.top + 30, buttons: 1, pointerId: 1};
  document.getElementById('chart').setPointerCapture = () => {};
  document.getElementById('chart').dispatchEvent(new PointerEvent('pointerdown', middle));
  player.draw();
  notes.clicked = player.time;
  const scene = document.getElementById('scene');
  scene.setPointerCapture = () => {};
  const point = (name, x, y, more) => scene.dispatchEvent(
    new PointerEvent(name, {clientX: x, clientY: y, buttons: 1, pointerId: 1, ...more}));
  const moves = (name, act) => {
    key('1');
    const before = picture();
    act();
    notes[name] = change(before, picture());
  };
  const drag = more => () => {
    point('pointerdown', 200, 200, more);
    point('pointermove', 260, 230, more);
    point('pointerup', 260, 230, more);
  };
  moves('turned', drag({}));
  moves('moved', drag({shiftKey: true}));
  moves('zoomed', () => scene.dispatchEvent(new WheelEvent('wheel', {deltaY: -300})));
  moves('pinched', () => {
    point('pointerdown', 200, 200, {pointerId: 2});
    point('pointerdown', 250, 200, {pointerId: 3});
    point('pointermove', 300, 200, {pointerId: 3});
    for (const pointerId of [2, 3]) point('pointerup', 200, 200, {pointerId});
  });
  moves('nothing', () => point('pointermove', 100, 100, {}));
  key('?');
  notes.help = document.getElementById('help').open;
  notes.requests = performance.getEntriesByType('resource').map(entry => entry.name);
  notes.width = [document.documentElement.scrollWidth, innerWidth];
  notes.unlabelled = [...document.querySelectorAll('button,input,select')].filter(one =>
    !one.getAttribute('aria-label') && !one.textContent.trim() && !one.closest('label')).map(one => one.id);
}
probe().catch(error => { notes.error = String(error.stack || error); })
       .then(() => { document.body.dataset.notes = JSON.stringify(notes); });
