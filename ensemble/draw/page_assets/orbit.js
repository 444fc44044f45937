'use strict';
// Where the scene is looked at from: one of the program's cameras, then turned, moved and zoomed by mouse, touch or pen.

class Orbit {
  constructor(canvas, changed) {
    this.canvas = canvas;
    this.changed = changed;
    this.target = new THREE.Vector3(); // relative to the structure while it is followed
    this.turn = new THREE.Quaternion(); // camera -> world
    this.height = 1; // m that the picture is high at the target
    this.angle = 0; // vertical angle of view; 0: parallel
    this.cut = 0; // m before the target, nearer than which nothing is seen; 0: all is
    this.follows = true;
    this.moved = false; // by hand since the last view was chosen
    this.perspective = new THREE.PerspectiveCamera();
    this.parallel = new THREE.OrthographicCamera();
    this.pointers = new Map();
    const on = (name, listener) => canvas.addEventListener(name, listener, {passive: false});
    on('pointerdown', event => this.press(event));
    on('pointermove', event => this.drag(event));
    for (const end of ['pointerup', 'pointercancel']) on(end, event => this.pointers.delete(event.pointerId));
    on('wheel', event => this.wheel(event));
    on('contextmenu', event => event.preventDefault());
  }

  // A view of the header, in a picture of this aspect. A view of a length must have it in its width.
  look(view, aspect) {
    const eye = new THREE.Vector3(...view.eye);
    this.target.set(...view.target);
    const matrix = new THREE.Matrix4().lookAt(eye, this.target, new THREE.Vector3(...view.up));
    this.turn.setFromRotationMatrix(matrix);
    this.angle = view.angle;
    this.cut = view.cut;
    this.height = view.length ? Math.max(view.height, view.length / aspect) : view.height / Math.min(1, 1.1 * aspect);
    this.moved = false;
  }

  // Follows or lets go without a jump.
  follow(follows, structure) {
    if (follows === this.follows) return;
    const way = follows ? -1 : 1;
    this.target.x += way * structure.x;
    this.target.z += way * structure.z;
    this.follows = follows;
    this.moved = true;
  }

  // The camera for a picture of this aspect while the structure is at `structure`, {x, z}.
  camera(aspect, structure) {
    const isParallel = this.angle === 0;
    const camera = isParallel ? this.parallel : this.perspective;
    const distance = isParallel ? 4 * this.height : this.height / (2 * Math.tan(this.angle / 2));
    camera.quaternion.copy(this.turn);
    camera.position.set(0, 0, distance).applyQuaternion(this.turn).add(this.target);
    if (this.follows) {
      camera.position.x += structure.x;
      camera.position.z += structure.z;
    }
    camera.near = !isParallel ? 0.04 * distance : this.cut > 0 ? distance - this.cut : 0.01 * distance;
    camera.far = isParallel ? distance + Math.max(2 * distance, 50 * this.cut) : 60 * distance;
    if (isParallel) {
      camera.top = this.height / 2;
      camera.bottom = -camera.top;
      camera.right = camera.top * aspect;
      camera.left = -camera.right;
    } else {
      camera.fov = this.angle * 180 / Math.PI;
      camera.aspect = aspect;
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, event);
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const dx = event.clientX - before.clientX;
    const dy = event.clientY - before.clientY;
    const others = [...this.pointers.values()].filter(one => one.pointerId !== event.pointerId);
    this.pointers.set(event.pointerId, event);
    if (others.length > 0) this.pinch(before, event, others[0], dx, dy);
    else if (event.shiftKey || event.ctrlKey || event.buttons & 6) this.pan(dx, dy);
    else this.rotate(dx, dy);
    this.moved = true;
    this.changed();
  }

  pinch(before, now, other, dx, dy) {
    const apart = one => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    this.zoom(Math.max(apart(before), 1) / Math.max(apart(now), 1));
    this.pan(0.5 * dx, 0.5 * dy);
  }

  // About the vertical and about the picture's horizontal, never over the head.
  rotate(dx, dy) {
    this.cut = 0;
    const radians = 2.5 / this.canvas.clientHeight;
    const about = (axis, angle) => new THREE.Quaternion().setFromAxisAngle(axis, angle);
    this.turn.premultiply(about(new THREE.Vector3(0, 1, 0), -dx * radians));
    const back = new THREE.Vector3(0, 0, 1).applyQuaternion(this.turn);
    const elevation = Math.asin(Math.min(Math.max(back.y, -1), 1));
    const most = Math.PI / 2 - 1e-3;
    const wanted = Math.min(Math.max(elevation + dy * radians, -most), most);
    this.turn.multiply(about(new THREE.Vector3(1, 0, 0), elevation - wanted)).normalize();
  }

  pan(dx, dy) {
    const metres = this.height / this.canvas.clientHeight;
    this.target.add(new THREE.Vector3(-dx * metres, dy * metres, 0).applyQuaternion(this.turn));
  }

  zoom(factor) {
    this.height *= factor;
    this.moved = true;
  }

  wheel(event) {
    event.preventDefault();
    this.zoom(Math.exp((event.deltaMode === 1 ? 30 : 1) * event.deltaY * 0.001));
    this.changed();
  }
}
