// The chosen particle: its mass, place, velocity and the forces on it, in numbers and as arrows.
import {$, few, make} from './dom.js';
import {arrow} from './marks.js';
import {colourOf} from './plots.js';

const INTERVAL = 150;                   // milliseconds between two questions
const LONGEST = 0.16;                   // of the picture's height
const digits = value => few(value, 3);
const vector = values => '(' + [...values].map(digits).join(', ') + ')';

export class Inspector {
  /** element: the picture; ask(id): asks for the forces on a particle, which are then shown */
  constructor(element, ask) {
    this.ask = ask;
    element.insertAdjacentHTML('beforeend', '<svg class="forces"></svg>');
    this.drawing = element.lastChild;
  }

  start() {
    Object.assign(this, {forces: {}, largest: 0, asked: 0});
  }

  /** A moment of the particle with index i; the forces of earlier moments are not kept. */
  show(id, state, i, past) {
    const now = performance.now();
    $('place').textContent = vector(state.subarray(6 * i, 6 * i + 3)) + ' m';
    $('velocity').textContent = vector(state.subarray(6 * i + 3, 6 * i + 6)) + ' m/s';
    if (past || id !== this.id) {
      this.tell({});
    }
    this.id = id;
    if (!past && now - this.asked > INTERVAL) {
      this.asked = now;
      this.ask(id);
    }
  }

  /** What the compiled classes answer: the mass and the forces by name. */
  answer({id, mass, forces}) {
    if (id === this.id) {
      $('mass').textContent = mass === undefined ? '' : digits(mass) + ' kg';
      this.tell(forces ?? {});
    }
  }

  tell(forces) {
    this.forces = forces;
    const names = Object.keys(forces);
    $('forceList').replaceChildren(...names.map(name =>
        make('div', {textContent: name + ' ' + vector(forces[name]) + ' N'})));
  }

  /** place(point) is where a point is seen; from is the particle's place, height that of the picture (m) */
  draw(place, from, height, on) {
    const lengths = Object.values(this.forces).map(force => Math.hypot(...force));
    this.largest = Math.max(this.largest, ...lengths);
    this.drawing.innerHTML = (on && from ? Object.entries(this.forces) : []).map(([name, force]) => {
      const start = place(from), end = place(from.map((x, c) => x + LONGEST * height / this.largest * force[c]));
      const line = arrow(start, end), colour = colourOf(name);
      return line && `<path d="${line}" stroke="${colour}" fill="${colour}"/><text x="${end[0] + 4}" y="${end[1] - 4}">
        ${name}</text>`;
    }).join('');
  }
}
