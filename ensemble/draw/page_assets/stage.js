'use strict';
// The scene as a whole: everything that is drawn in three dimensions, at a time.

class Stage {
  constructor(canvas, replay, changed) {
    this.replay = replay;
    this.canvas = canvas;
    const {header} = replay;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.scene = new THREE.Scene();
    this.ice = new Ice(replay);
    this.colouring = new Colouring(replay);
    this.structure = makeStructure(header);
    this.sheets = makeSheets(header);
    this.water = makeWater(header);
    const contacts = Math.max(...Array.from({length: replay.frames},
      (_, f) => replay.firstContact[f + 1] - replay.firstContact[f]));
    const lines = Math.max(0, ...(header.lines || []).map(held => held.length));
    this.arrows = new Arrows(2 * contacts + lines + 5);
    this.scene.add(makeLights(), this.ice.mesh, this.structure, this.sheets, this.water);
    this.overlay = new THREE.Scene().add(this.arrows.mesh);
    this.renderer.autoClear = false;
    this.orbit = new Orbit(canvas, changed);
    this.shows = {load: true, contacts: true, ice: true};
    const {radius} = header.structure;
    this.newtons = roundNumber(replay.strongLoad() / (2.2 * radius)); // that an arrow of 1 m stands for
    this.longer = 1;
    this.useTheme();
  }

  useTheme() {
    for (const part of [this.ice, this.structure, this.sheets, this.water]) part.useTheme();
    this.coloured = null;
  }

  // Pixels of the page that a metre takes at the structure.
  get pixelsPerMetre() {
    return this.canvas.clientHeight / this.orbit.height;
  }

  get aspect() {
    return this.canvas.clientWidth / Math.max(this.canvas.clientHeight, 1);
  }

  look(name) {
    const {views} = this.replay.header;
    const view = views.find(one => one.name === name);
    if (!view) return false;
    this.orbit.look(view, this.aspect);
    this.orbit.follows = view.follows;
    return true;
  }

  // Floes with a failed joint.
  brokenFloes(time) {
    return new Set(this.replay.failuresUntil(time).map(failure => failure[2]));
  }

  colour(frame, broken) {
    const key = [frame, this.colouring.kind, broken.size].join();
    if (key === this.coloured) return;
    this.coloured = key;
    this.ice.refill('tint', this.colouring.at(frame, broken));
  }

  draw(time) {
    const {replay, renderer, canvas} = this;
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const width = canvas.clientWidth;
    const height = canvas.clientHeight;
    if (canvas.width !== Math.floor(width * scale) || canvas.height !== Math.floor(height * scale)) {
      renderer.setPixelRatio(scale);
      renderer.setSize(width, height, false);
    }
    const frame = replay.nearestFrame(time);
    const failures = replay.failuresUntil(time);
    const broken = this.brokenFloes(time);
    this.ice.moveTo(time);
    this.ice.markFailures(failures, broken);
    this.colour(frame, broken);
    const structure = replay.structureAt(time);
    this.structure.position.set(structure.x, structure.y, structure.z);
    this.structure.rotation.set(structure.roll, structure.yaw, structure.pitch, 'YZX'); // yaw, then pitch, then roll
    this.arrows.show([towArrow(replay, time), ...lineArrows(replay, frame), ...forceArrows(replay, frame, time, this.longer / this.newtons, this.shows)]);
    const camera = this.orbit.camera(this.aspect, structure);
    this.ice.lookFrom(camera);
    renderer.setClearColor(styled(camera.position.y < 0 ? 'deep' : 'far'));
    renderer.clear();
    renderer.render(this.scene, camera);
    renderer.clearDepth();
    renderer.render(this.overlay, camera);
  }
}
