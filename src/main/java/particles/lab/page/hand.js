// Mouse and finger on the picture: a click chooses a particle, a pull drags it; beside the particles it turns the view.
const STILL = 4, REACH = {mouse: 14, pen: 20, touch: 28};       // pixels

export class Hand {
  /**
   * view: says what is where; picked(id): a particle was clicked; dragged(id, point): one is dragged towards a point,
   * or let go, and then the point is null; dragged may be null, where nothing can be
   */
  constructor(element, view, picked, dragged) {
    Object.assign(this, {element, view, picked, dragged, held: null});
    // before the camera's controls, which turn the picture
    element.addEventListener('pointerdown', event => this.down(event), true);
    element.addEventListener('pointermove', event => this.move(event));
    element.addEventListener('pointerup', event => this.up(event));
    element.addEventListener('pointercancel', event => this.up(event));
    element.addEventListener('touchstart', event => this.view.nearest(event.touches[0], REACH.touch) >= 0
        && event.preventDefault(), {passive: false});           // the page must not scroll
  }

  down(event) {
    const i = event.button === 0 ? this.view.nearest(event, REACH[event.pointerType] ?? REACH.mouse) : -1;
    if (i < 0) {
      return;
    }
    event.stopPropagation();
    this.element.setPointerCapture(event.pointerId);
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
    this.dragged(held.id, point);
  }

  up() {
    if (this.held?.moved) {
      this.view.pull = null;
      this.view.stale = true;
      this.dragged(this.held.id, null);
    } else if (this.held) {
      this.picked(this.held.id);
    }
    this.held = null;
  }
}
