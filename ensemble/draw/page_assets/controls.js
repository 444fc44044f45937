'use strict';
// What a person does with mouse, touch or keys, handed on to the player. The view itself is turned by Orbit.

const $ = id => document.getElementById(id);

class Controls {
  constructor(player) {
    this.player = player;
    const on = (id, name, listener) => $(id).addEventListener(name, listener);
    on('play', 'click', () => player.play(!player.playing));
    on('back', 'click', () => player.step(-1));
    on('ahead', 'click', () => player.step(1));
    on('scrub', 'input', () => player.go(Number($('scrub').value)));
    on('largest', 'click', () => player.goToLargestLoad());
    on('speed', 'change', () => { player.speed = Number($('speed').value); });
    on('component', 'change', () => player.setComponent());
    on('span', 'click', () => {
      player.chart.whole = !player.chart.whole;
      $('span').textContent = player.chart.whole ? 'Frames only' : 'Whole run';
      player.redraw();
    });
    on('follow', 'change', () => player.setFollow($('follow').checked));
    on('see-through', 'change', () => {
      player.stage.structure.seeThrough($('see-through').checked);
      player.redraw();
    });
    on('colouring', 'change', () => player.setColour($('colouring').value));
    for (const id of ['load-arrows', 'contact-arrows', 'ice-arrows', 'arrow-scale']) on(id, 'change', () => player.setArrows());
    on('ask', 'click', () => $('help').showModal());
    window.addEventListener('keydown', event => this.key(event));
    window.addEventListener('hashchange', () => player.readHash());
    window.addEventListener('resize', () => {
      if (!player.stage.orbit.moved) player.setView(player.view);
      player.redraw();
    });
    dark.addEventListener('change', () => {
      player.stage.useTheme();
      player.showLegend();
      player.redraw();
    });
  }

  key(event) {
    const {player} = this;
    if (event.ctrlKey || event.metaKey || event.altKey || $('help').open) return;
    // A control that was reached by keyboard keeps its own keys.
    if (event.target.matches('select:focus-visible')) return;
    if (event.key === ' ' && event.target.matches('button:focus-visible,summary:focus-visible,[type=checkbox]:focus-visible'))
      return;
    const flip = id => {
      $(id).checked = !$(id).checked;
      $(id).dispatchEvent(new Event('change'));
    };
    const next = (id, by = 1) => {
      const list = $(id);
      list.selectedIndex = Math.min(Math.max(list.selectedIndex + by, 0), list.length - 1);
      list.dispatchEvent(new Event('change'));
    };
    const cycle = id => next(id, $(id).selectedIndex === $(id).length - 1 ? -$(id).length : 1);
    const {views} = player.replay.header;
    const keys = {
      ' ': () => player.play(!player.playing),
      ArrowLeft: () => player.step(event.shiftKey ? -10 : -1),
      ArrowRight: () => player.step(event.shiftKey ? 10 : 1),
      ArrowUp: () => next('speed'),
      ArrowDown: () => next('speed', -1),
      Home: () => player.go(player.replay.begin),
      End: () => player.go(player.replay.end),
      c: () => cycle('colouring'),
      l: () => cycle('component'),
      m: () => player.goToLargestLoad(),
      '+': () => player.zoom(1 / 1.2),
      '-': () => player.zoom(1.2),
      s: () => flip('follow'),
      x: () => flip('see-through'),
      f: () => {
        const ids = ['load-arrows', 'contact-arrows', 'ice-arrows'];
        const all = !ids.some(id => $(id).checked);
        for (const id of ids) $(id).checked = all;
        player.setArrows();
      },
      '?': () => $('help').showModal(),
    };
    const act = keys[event.key] || (views[event.key - 1] && (() => player.setView(views[event.key - 1].name)));
    if (!act) return;
    event.preventDefault();
    act();
  }
}
