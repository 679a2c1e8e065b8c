// Mouse and finger on the picture: a click chooses a particle, a pull drags it; beside the particles it turns the view.
// Where somebody builds, a click beside them places one, and a pull joins two.
const STILL = 4, REACH = {mouse: 14, pen: 20, touch: 28};       // pixels

export class Hand {
  /**
   * view: says what is where; picked(id): a particle was clicked; dragged(id, point): one is dragged towards a point,
   * or let go, and then the point is null; dragged may be null, where nothing can be
   */
  constructor(element, view, picked, dragged) {
    Object.assign(this, {element, view, picked, dragged, held: null, builder: null});
    // before the camera's controls, which turn the picture
    element.addEventListener('pointerdown', event => this.down(event), true);
    element.addEventListener('pointermove', event => this.move(event));
    element.addEventListener('pointerup', event => this.up(event));
    element.addEventListener('pointercancel', event => this.up(event));
    element.addEventListener('touchstart', event => this.at(event.touches[0]) >= 0
        && event.preventDefault(), {passive: false});           // the page must not scroll
  }

  /** The particle under a pointer or a finger; -1 without one. */
  at(pointer) {
    return this.view.nearest(pointer, REACH[pointer.pointerType] ?? REACH.touch, this.builder);
  }

  down(event) {
    const i = this.at(event);
    if (event.button || i < 0 && !this.builder) {
      return;
    }
    if (i >= 0) {
      event.stopPropagation();
      this.element.setPointerCapture(event.pointerId);
    }
    this.held = {id: this.view.structure.ids[i], x: event.clientX, y: event.clientY, moved: false};
  }

  move(event) {
    const held = this.held;
    if (!held || !this.dragged || !held.moved && Math.hypot(event.clientX - held.x, event.clientY - held.y) < STILL) {
      return;
    }
    held.moved = true;
    const i = this.view.structure.ids.indexOf(held.id);
    if (i < 0) {
      this.up(event);                   // it has died
      return;
    }
    const point = this.view.pointUnder(event, i);
    this.view.pull = {id: held.id, point};
    this.view.stale = true;
    this.builder || this.dragged(held.id, point);
  }

  up(event) {
    const {held, builder, view} = this, done = event.type === 'pointerup';
    this.held = view.pull = null;
    view.stale = true;
    if (held?.moved) {
      builder ? done && held.id && builder.join(held.id, view.structure.ids[this.at(event)])
          : this.dragged(held.id, null);
    } else if (held && done) {
      held.id ? this.picked(held.id) : builder.place(event);
    }
  }
}
